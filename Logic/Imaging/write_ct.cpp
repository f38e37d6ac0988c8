#include "Imaging/write_ct.hpp"

#include "Core/error.hpp"

#include <itkImageFileWriter.h>
#include <itkNrrdImageIO.h>

namespace f2b
{

void write_ct(const CtImage& ct, const std::filesystem::path& path)
{
  auto writer = itk::ImageFileWriter<CtImage>::New();
  writer->SetImageIO(itk::NrrdImageIO::New());
  writer->SetFileName(path.string());
  writer->SetInput(&ct);
  writer->UseCompressionOn();
  try
  {
    writer->Update();
  }
  catch (const itk::ExceptionObject&)
  {
    throw Error(path.string(), "it cannot be written",
                "check the folder's permissions and free space");
  }
}

} // namespace f2b

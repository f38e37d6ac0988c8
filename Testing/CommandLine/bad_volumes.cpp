#include "CommandLine/bad_volumes.hpp"

#include <Imaging/quiet_streams.hpp>

#include <itkGDCMImageIO.h>
#include <itkMetaDataObject.h>

#include <fstream>
#include <vector>

namespace f2b::test
{

void write_nrrd(const std::filesystem::path& file, const Volume& volume)
{
  std::ofstream out(file, std::ios::binary);
  out << "NRRD0004\ntype: " << volume.type
      << "\ndimension: 3\nspace: left-posterior-superior\nsizes:";
  for (const int size : volume.size)
    out << " " << size;
  out << "\nspace directions: (" << volume.spacing[0] << ",0,0) (0," << volume.spacing[1]
      << ",0) (0,0," << volume.spacing[2]
      << ")\nkinds: domain domain domain\nendian: little\nencoding: raw\n"
      << "space origin: (-100,-100,-100)\n\n";
  for (int k = 0; k < volume.size[2]; ++k)
    for (int j = 0; j < volume.size[1]; ++j)
      for (int i = 0; i < volume.size[0]; ++i)
      {
        const int value = volume.value(i, j, k);
        out.put(static_cast<char>(value & 0xff));
        if (volume.type == "short")
          out.put(static_cast<char>((value >> 8) & 0xff));
      }
}

void write_dicom_series(const std::filesystem::path& folder, const std::string& name,
                        const std::string& uid)
{
  const QuietStreams quiet;
  std::vector<short> slice(400, -1000);
  for (std::size_t i = 120; i < 280; ++i)
    slice[i] = 400;
  for (unsigned k = 0; k < 20; ++k)
  {
    auto io = itk::GDCMImageIO::New();
    io->KeepOriginalUIDOn();
    itk::MetaDataDictionary tags;
    auto put = [&](const char* key, const std::string& value)
    { itk::EncapsulateMetaData<std::string>(tags, key, value); };
    put("0008|0060", "CT");
    put("0008|103e", name);
    put("0020|000e", uid);
    put("0020|000d", "1.2.826.0.1.3680043.2.1125.9");
    put("0008|0018", uid + "." + std::to_string(k + 1));
    put("0020|0013", std::to_string(k + 1));
    io->SetMetaDataDictionary(tags);
    io->SetNumberOfDimensions(3);
    itk::ImageIORegion region(3);
    for (unsigned a = 0; a < 3; ++a)
    {
      io->SetDimensions(a, a < 2 ? 20 : 1);
      region.SetSize(a, a < 2 ? 20 : 1);
      io->SetSpacing(a, 2.0);
      io->SetOrigin(a, a == 2 ? 2.0 * k : 0.0);
    }
    io->SetPixelType(itk::IOPixelEnum::SCALAR);
    io->SetComponentType(itk::IOComponentEnum::SHORT);
    io->SetNumberOfComponents(1);
    io->SetIORegion(region);
    io->SetFileName((folder / (name + " " + std::to_string(k) + ".dcm")).string());
    io->WriteImageInformation();
    io->Write(slice.data());
  }
}

} // namespace f2b::test

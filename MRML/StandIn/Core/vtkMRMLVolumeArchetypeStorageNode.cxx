#include "vtkMRMLVolumeArchetypeStorageNode.h"

#include "vtkMRMLMessageCollection.h"
#include "vtkMRMLVolumeNode.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkStringArray.h>

#include <itkImageIOFactory.h>
#include <itkMetaImageIOFactory.h>
#include <itkNiftiImageIOFactory.h>
#include <itkNrrdImageIOFactory.h>

#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <limits>
#include <stdexcept>

vtkMRMLNodeNewMacro(vtkMRMLVolumeArchetypeStorageNode);

namespace
{

void RegisterFormats()
{
  static const bool registered = []
  {
    itk::NrrdImageIOFactory::RegisterOneFactory();
    itk::MetaImageIOFactory::RegisterOneFactory();
    itk::NiftiImageIOFactory::RegisterOneFactory();
    return true;
  }();
  static_cast<void>(registered);
}

struct VoxelType
{
  itk::IOComponentEnum Itk;
  int Vtk;
};
const VoxelType voxelTypes[] = {
    {itk::IOComponentEnum::UCHAR, VTK_UNSIGNED_CHAR},
    {itk::IOComponentEnum::CHAR, VTK_SIGNED_CHAR},
    {itk::IOComponentEnum::USHORT, VTK_UNSIGNED_SHORT},
    {itk::IOComponentEnum::SHORT, VTK_SHORT},
    {itk::IOComponentEnum::UINT, VTK_UNSIGNED_INT},
    {itk::IOComponentEnum::INT, VTK_INT},
    {itk::IOComponentEnum::ULONG, VTK_UNSIGNED_LONG},
    {itk::IOComponentEnum::LONG, VTK_LONG},
    {itk::IOComponentEnum::ULONGLONG, VTK_UNSIGNED_LONG_LONG},
    {itk::IOComponentEnum::LONGLONG, VTK_LONG_LONG},
    {itk::IOComponentEnum::FLOAT, VTK_FLOAT},
    {itk::IOComponentEnum::DOUBLE, VTK_DOUBLE},
};

int VtkType(itk::IOComponentEnum itkType)
{
  for (const VoxelType& type : voxelTypes)
  {
    if (type.Itk == itkType)
    {
      return type.Vtk;
    }
  }
  throw std::runtime_error("its voxels are of a type that is not known here");
}

itk::IOComponentEnum ItkType(int vtkType)
{
  for (const VoxelType& type : voxelTypes)
  {
    if (type.Vtk == (vtkType == VTK_CHAR ? VTK_SIGNED_CHAR : vtkType))
    {
      return type.Itk;
    }
  }
  throw std::runtime_error("voxels of this type cannot be written");
}

/// A CT's memory is touched first while it is read: with large pages that is a third of the time.
void AskForLargePages(vtkImageData* image)
{
  const auto page = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
  const auto begin = reinterpret_cast<std::uintptr_t>(image->GetScalarPointer());
  const auto first = (begin + page - 1) / page * page;
  const auto end = begin + static_cast<std::uintptr_t>(image->GetScalarSize()) *
                               static_cast<std::uintptr_t>(image->GetNumberOfPoints());
  if (end > first)
  {
    madvise(reinterpret_cast<void*>(first), end - first, MADV_HUGEPAGE); // a wish, not a need
  }
}

/// Unit spacing and zero origin, as a volume node wants it. Throws where the file is damaged.
vtkSmartPointer<vtkImageData> ReadImage(itk::ImageIOBase* io)
{
  const unsigned int dimensions = io->GetNumberOfDimensions();
  if (dimensions < 2 || dimensions > 4 || (dimensions == 4 && io->GetDimensions(3) != 1) ||
      io->GetNumberOfComponents() != 1)
  {
    throw std::runtime_error("it is no volume of one number a voxel");
  }
  itk::ImageIORegion region(dimensions);
  double voxels = 1.0;
  int size[3] = {1, 1, 1};
  for (unsigned int i = 0; i < dimensions; ++i)
  {
    region.SetIndex(i, 0);
    region.SetSize(i, io->GetDimensions(i));
    voxels *= static_cast<double>(io->GetDimensions(i));
    if (i < 3)
    {
      size[i] = static_cast<int>(io->GetDimensions(i));
    }
  }
  if (voxels < 1.0 || voxels > 4.0e9)
  {
    throw std::runtime_error("its size is impossible");
  }
  const auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(size);
  image->AllocateScalars(VtkType(io->GetComponentType()), 1);
  AskForLargePages(image);
  io->SetIORegion(region);
  io->Read(image->GetScalarPointer());
  image->GetPointData()->GetScalars()->SetName("ImageScalars");
  return image;
}

void ReadGeometry(itk::ImageIOBase* io, bool oriented, vtkMRMLVolumeNode* volume)
{
  vtkNew<vtkMatrix4x4> matrix;
  const unsigned int dimensions = std::min(io->GetNumberOfDimensions(), 3U);
  for (unsigned int axis = 0; axis < dimensions; ++axis)
  {
    const std::vector<double> direction = io->GetDirection(axis);
    for (unsigned int row = 0; row < 3; ++row)
    {
      const double along = row < direction.size() ? direction[row] : 0.0;
      const double sign = row < 2 ? -1.0 : 1.0;
      const double plain = row == axis ? 1.0 : 0.0;
      matrix->SetElement(row, axis, sign * io->GetSpacing(axis) * (oriented ? along : plain));
    }
    matrix->SetElement(axis, 3, (axis < 2 ? -1.0 : 1.0) * io->GetOrigin(axis));
  }
  if (matrix->Determinant() == 0.0)
  {
    throw std::runtime_error("its axes or spacings span no volume");
  }
  volume->SetIJKToRASMatrix(matrix);
}

} // namespace

vtkMRMLVolumeArchetypeStorageNode::vtkMRMLVolumeArchetypeStorageNode()
{
  this->DefaultWriteFileExtension = "nrrd";
}

void vtkMRMLVolumeArchetypeStorageNode::ReadXMLAttributes(const char** atts)
{
  MRMLNodeModifyBlocker blocker(this);
  this->Superclass::ReadXMLAttributes(atts);
  vtkMRMLReadXMLBeginMacro(atts);
  vtkMRMLReadXMLIntMacro(centerImage, CenterImage);
  vtkMRMLReadXMLIntMacro(UseOrientationFromFile, UseOrientationFromFile);
  vtkMRMLReadXMLEndMacro();
  this->SingleFile = this->GetNumberOfFileNames() <= 1;
}

void vtkMRMLVolumeArchetypeStorageNode::WriteXML(ostream& of, int indent)
{
  this->Superclass::WriteXML(of, indent);
  vtkMRMLWriteXMLBeginMacro(of);
  vtkMRMLWriteXMLIntMacro(centerImage, CenterImage);
  vtkMRMLWriteXMLIntMacro(UseOrientationFromFile, UseOrientationFromFile);
  vtkMRMLWriteXMLEndMacro();
}

void vtkMRMLVolumeArchetypeStorageNode::Copy(vtkMRMLNode* node)
{
  MRMLNodeModifyBlocker blocker(this);
  this->Superclass::Copy(node);
  vtkMRMLCopyBeginMacro(node);
  vtkMRMLCopyIntMacro(CenterImage);
  vtkMRMLCopyIntMacro(SingleFile);
  vtkMRMLCopyIntMacro(UseOrientationFromFile);
  vtkMRMLCopyEndMacro();
}

bool vtkMRMLVolumeArchetypeStorageNode::CanReadInReferenceNode(vtkMRMLNode* refNode)
{
  return refNode && refNode->IsA("vtkMRMLScalarVolumeNode");
}

void vtkMRMLVolumeArchetypeStorageNode::InitializeSupportedReadFileTypes()
{
  for (const char* type : {"NRRD (.nrrd)", "NRRD (.nhdr)", "MetaImage (.mha)", "MetaImage (.mhd)",
                           "NIfTI (.nii)", "NIfTI (.nii.gz)"})
  {
    this->SupportedReadFileTypes->InsertNextValue(type);
  }
}

void vtkMRMLVolumeArchetypeStorageNode::InitializeSupportedWriteFileTypes()
{
  for (const char* type : {"NRRD (.nrrd)", "MetaImage (.mha)", "NIfTI (.nii)", "NIfTI (.nii.gz)"})
  {
    this->SupportedWriteFileTypes->InsertNextValue(type);
  }
}

int vtkMRMLVolumeArchetypeStorageNode::ReadDataInternal(vtkMRMLNode* refNode)
{
  RegisterFormats();
  const std::string path = this->GetFullNameFromFileName();
  auto* volume = static_cast<vtkMRMLVolumeNode*>(refNode);
  try
  {
    const auto io = itk::ImageIOFactory::CreateImageIO(path.c_str(), itk::IOFileModeEnum::ReadMode);
    if (!io)
    {
      throw std::runtime_error("its format is not known here");
    }
    io->SetFileName(path);
    io->ReadImageInformation();
    const vtkSmartPointer<vtkImageData> image = ReadImage(io);
    MRMLNodeModifyBlocker blocker(volume);
    ReadGeometry(io, this->UseOrientationFromFile != 0, volume);
    volume->SetAndObserveImageData(image);
  }
  catch (const std::exception& exception)
  {
    vtkErrorToMessageCollectionMacro(this->UserMessages, this->GetClassName(),
                                     path << ": " << exception.what());
    return 0;
  }
  return 1;
}

int vtkMRMLVolumeArchetypeStorageNode::WriteDataInternal(vtkMRMLNode* refNode)
{
  RegisterFormats();
  auto* volume = static_cast<vtkMRMLVolumeNode*>(refNode);
  vtkImageData* image = volume->GetImageData();
  if (!image || !image->GetScalarPointer())
  {
    this->SetWriteStateSkippedNoData();
    return 1;
  }
  const std::string path = this->GetTemporaryFileName();
  try
  {
    const auto io =
        itk::ImageIOFactory::CreateImageIO(path.c_str(), itk::IOFileModeEnum::WriteMode);
    if (!io || this->GetSupportedFileExtension(path.c_str(), false, true).empty())
    {
      throw std::runtime_error("volumes of this format are not written");
    }
    io->SetNumberOfDimensions(3);
    io->SetNumberOfComponents(1);
    io->SetPixelType(itk::IOPixelEnum::SCALAR);
    io->SetComponentType(ItkType(image->GetScalarType()));
    io->SetUseCompression(this->UseCompression != 0);
    vtkNew<vtkMatrix4x4> matrix;
    volume->GetIJKToRASDirectionMatrix(matrix);
    itk::ImageIORegion region(3);
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      const auto size = static_cast<itk::SizeValueType>(image->GetDimensions()[axis]);
      io->SetDimensions(axis, size);
      region.SetIndex(axis, 0);
      region.SetSize(axis, size);
      io->SetSpacing(axis, volume->GetSpacing()[axis]);
      io->SetOrigin(axis, (axis < 2 ? -1.0 : 1.0) * volume->GetOrigin()[axis]);
      io->SetDirection(axis, std::vector<double>{-matrix->GetElement(0, axis),
                                                 -matrix->GetElement(1, axis),
                                                 matrix->GetElement(2, axis)});
    }
    io->SetIORegion(region);
    io->SetFileName(path);
    io->WriteImageInformation();
    io->Write(image->GetScalarPointer());
  }
  catch (const std::exception& exception)
  {
    vtkErrorToMessageCollectionMacro(this->UserMessages, this->GetClassName(), exception.what());
    return 0;
  }
  return 1;
}

#include "vtkMRMLTransformStorageNode.h"

#include "vtkMRMLMessageCollection.h"
#include "vtkMRMLTransformNode.h"

#include <vtkMatrix4x4.h>
#include <vtkObjectFactory.h>
#include <vtkStringArray.h>

#include <itkAffineTransform.h>
#include <itkHDF5TransformIOFactory.h>
#include <itkIdentityTransform.h>
#include <itkMatrixOffsetTransformBase.h>
#include <itkTransformFactoryBase.h>
#include <itkTransformFileReader.h>
#include <itkTransformFileWriter.h>
#include <itkTranslationTransform.h>
#include <itkTxtTransformIOFactory.h>

vtkMRMLNodeNewMacro(vtkMRMLTransformStorageNode);

namespace
{

void RegisterFormats()
{
  static const bool registered = []
  {
    itk::TransformFactoryBase::RegisterDefaultTransforms();
    itk::TxtTransformIOFactory::RegisterOneFactory();
    itk::HDF5TransformIOFactory::RegisterOneFactory();
    return true;
  }();
  static_cast<void>(registered);
}

/// LPS to RAS and back.
void Flip(vtkMatrix4x4* matrix)
{
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 4; ++j)
    {
      if ((i < 2) != (j < 2))
      {
        matrix->SetElement(i, j, -matrix->GetElement(i, j));
      }
    }
  }
}

/// False where the transform is not linear, or not of 3D.
template <class Number>
bool MatrixFromItk(itk::TransformBaseTemplate<Number>* transform, vtkMatrix4x4* matrix)
{
  matrix->Identity();
  if (dynamic_cast<itk::IdentityTransform<Number, 3>*>(transform))
  {
    return true;
  }
  if (auto* shift = dynamic_cast<itk::TranslationTransform<Number, 3>*>(transform))
  {
    for (int i = 0; i < 3; ++i)
    {
      matrix->SetElement(i, 3, shift->GetOffset()[i]);
    }
    return true;
  }
  auto* linear = dynamic_cast<itk::MatrixOffsetTransformBase<Number, 3, 3>*>(transform);
  if (!linear)
  {
    return false;
  }
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      matrix->SetElement(i, j, linear->GetMatrix()[i][j]);
    }
    matrix->SetElement(i, 3, linear->GetOffset()[i]);
  }
  return true;
}

template <class Number>
bool ReadMatrix(const std::string& path, vtkMatrix4x4* matrix)
{
  auto reader = itk::TransformFileReaderTemplate<Number>::New();
  reader->SetFileName(path);
  reader->Update();
  const auto* transforms = reader->GetTransformList();
  return transforms->size() == 1 && MatrixFromItk<Number>(transforms->front(), matrix);
}

} // namespace

vtkMRMLTransformStorageNode::vtkMRMLTransformStorageNode()
{
  this->DefaultWriteFileExtension = "h5";
}

void vtkMRMLTransformStorageNode::ReadXMLAttributes(const char** atts)
{
  MRMLNodeModifyBlocker blocker(this);
  this->Superclass::ReadXMLAttributes(atts);
  vtkMRMLReadXMLBeginMacro(atts);
  vtkMRMLReadXMLBooleanMacro(preferITKv3CompatibleTransforms, PreferITKv3CompatibleTransforms);
  vtkMRMLReadXMLEndMacro();
}

void vtkMRMLTransformStorageNode::WriteXML(ostream& of, int indent)
{
  this->Superclass::WriteXML(of, indent);
  vtkMRMLWriteXMLBeginMacro(of);
  vtkMRMLWriteXMLBooleanMacro(preferITKv3CompatibleTransforms, PreferITKv3CompatibleTransforms);
  vtkMRMLWriteXMLEndMacro();
}

void vtkMRMLTransformStorageNode::Copy(vtkMRMLNode* node)
{
  MRMLNodeModifyBlocker blocker(this);
  this->Superclass::Copy(node);
  if (auto* source = vtkMRMLTransformStorageNode::SafeDownCast(node))
  {
    this->SetPreferITKv3CompatibleTransforms(source->PreferITKv3CompatibleTransforms);
  }
}

bool vtkMRMLTransformStorageNode::CanReadInReferenceNode(vtkMRMLNode* refNode)
{
  return refNode && refNode->IsA("vtkMRMLTransformNode");
}

void vtkMRMLTransformStorageNode::InitializeSupportedReadFileTypes()
{
  for (const char* type : {"Transform (.h5)", "Transform (.tfm)", "Text (.txt)"})
  {
    this->SupportedReadFileTypes->InsertNextValue(type);
  }
}

void vtkMRMLTransformStorageNode::InitializeSupportedWriteFileTypes()
{
  for (const char* type : {"Transform (.h5)", "Transform (.tfm)", "Text (.txt)"})
  {
    this->SupportedWriteFileTypes->InsertNextValue(type);
  }
}

int vtkMRMLTransformStorageNode::ReadDataInternal(vtkMRMLNode* refNode)
{
  RegisterFormats();
  const std::string path = this->GetFullNameFromFileName();
  vtkNew<vtkMatrix4x4> fromParent;
  bool read = false;
  std::string fault = "it holds no single linear transform";
  try
  {
    read = ReadMatrix<double>(path, fromParent) || ReadMatrix<float>(path, fromParent);
  }
  catch (const std::exception& exception)
  {
    fault = exception.what();
  }
  if (!read || fromParent->Determinant() == 0.0)
  {
    vtkErrorToMessageCollectionMacro(this->UserMessages, this->GetClassName(),
                                     path << ": " << (read ? "its matrix is singular" : fault));
    return 0;
  }
  Flip(fromParent);
  static_cast<vtkMRMLTransformNode*>(refNode)->SetMatrixTransformFromParent(fromParent);
  return 1;
}

int vtkMRMLTransformStorageNode::WriteDataInternal(vtkMRMLNode* refNode)
{
  RegisterFormats();
  vtkNew<vtkMatrix4x4> fromParent;
  if (!static_cast<vtkMRMLTransformNode*>(refNode)->GetMatrixTransformFromParent(fromParent))
  {
    return 0;
  }
  Flip(fromParent);
  auto affine = itk::AffineTransform<double, 3>::New();
  itk::Matrix<double, 3, 3> matrix;
  itk::Vector<double, 3> offset;
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      matrix[i][j] = fromParent->GetElement(i, j);
    }
    offset[i] = fromParent->GetElement(i, 3);
  }
  affine->SetMatrix(matrix);
  affine->SetOffset(offset);
  try
  {
    auto writer = itk::TransformFileWriterTemplate<double>::New();
    writer->SetInput(affine);
    writer->SetFileName(this->GetTemporaryFileName());
    writer->Update();
  }
  catch (const std::exception& exception)
  {
    vtkErrorToMessageCollectionMacro(this->UserMessages, this->GetClassName(), exception.what());
    return 0;
  }
  return 1;
}

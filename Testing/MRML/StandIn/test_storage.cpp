// Data files of models, transforms, volumes and colours, by what Slicer writes and reads.
#include "scene_test.hpp"

#include <vtkMRMLColorTableNode.h>
#include <vtkMRMLLabelMapVolumeNode.h>
#include <vtkMRMLLinearTransformNode.h>
#include <vtkMRMLModelStorageNode.h>
#include <vtkMRMLScalarVolumeNode.h>
#include <vtkMRMLVolumeArchetypeStorageNode.h>

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkMath.h>
#include <vtkMatrix4x4.h>
#include <vtkPointData.h>
#include <vtkTransform.h>
#include <vtkUnstructuredGrid.h>
#include <vtkVector.h>

#include <algorithm>
#include <cmath>
#include <sstream>

using namespace f2b::test;

namespace
{

/// What the data of a node's file look like to another node of the class.
template <class Node>
Node* read_again(vtkMRMLScene* scene, vtkMRMLStorableNode* written)
{
  auto* node = add_node<Node>(scene, "again");
  const auto storage =
      vtkSmartPointer<vtkMRMLStorageNode>::Take(written->CreateDefaultStorageNode());
  storage->SetFileName(written->GetStorageNode()->GetFileName());
  scene->AddNode(storage);
  return storage->ReadData(node) ? node : nullptr;
}

double distance(vtkPointSet* a, vtkPointSet* b)
{
  double largest = 0.0;
  for (vtkIdType i = 0; i < a->GetNumberOfPoints(); ++i)
  {
    double p[3];
    double q[3];
    a->GetPoint(i, p);
    b->GetPoint(i, q);
    largest = std::max(largest, std::sqrt(vtkMath::Distance2BetweenPoints(p, q)));
  }
  return largest;
}

/// x and y of the first number-triple after a word in a text file.
vtkVector2d first_point(const std::string& text, const std::string& after)
{
  std::istringstream numbers(text.substr(text.find(after) + after.size()));
  vtkVector2d point;
  numbers >> point[0] >> point[1];
  return point;
}

} // namespace

// --- Models ------------------------------------------------------------------------------------

class SurfaceFileTest : public ::testing::TestWithParam<const char*>
{
};

TEST_P(SurfaceFileTest, ComesBackInItsPlace)
{
  const TemporaryFolder folder;
  vtkNew<vtkMRMLScene> scene;
  auto* skin = add_model(scene, "skin");
  ASSERT_TRUE(save_data(skin, folder / ("skin ü." + std::string(GetParam()))));
  auto* back = read_again<vtkMRMLModelNode>(scene, skin);
  ASSERT_NE(nullptr, back);
  ASSERT_NE(nullptr, back->GetPolyData());
  EXPECT_EQ(skin->GetPolyData()->GetNumberOfCells(), back->GetPolyData()->GetNumberOfCells());
  double expected[6];
  double bounds[6];
  skin->GetRASBounds(expected);
  back->GetRASBounds(bounds);
  for (int i = 0; i < 6; ++i)
  {
    EXPECT_NEAR(expected[i], bounds[i], 1e-4) << i;
  }
  EXPECT_EQ(1U, folder.file_count()) << "nothing else is left in the folder";
}

INSTANTIATE_TEST_SUITE_P(Formats, SurfaceFileTest,
                         ::testing::Values("vtp", "vtk", "stl", "ply", "obj"));

TEST(ModelFileTest, FilesAreLpsAndSaySo)
{
  const TemporaryFolder folder;
  vtkNew<vtkMRMLScene> scene;
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(1.0, 2.0, 3.0);
  points->InsertNextPoint(2.0, 2.0, 3.0);
  points->InsertNextPoint(1.0, 3.0, 3.0);
  vtkNew<vtkCellArray> triangle;
  triangle->InsertNextCell({0, 1, 2});
  vtkNew<vtkPolyData> surface;
  surface->SetPoints(points);
  surface->SetPolys(triangle);
  auto* model = add_model(scene, "one", surface);
  ASSERT_TRUE(save_data(model, folder / "one.obj"));
  const vtkVector2d written = first_point(read_text(folder / "one.obj"), "v ");
  EXPECT_EQ(-1.0, written[0]);
  EXPECT_EQ(-2.0, written[1]);
  ASSERT_TRUE(save_data(model, folder / "one.vtp"));
  EXPECT_NE(std::string::npos, read_text(folder / "one.vtp").find("SPACE"));
  ASSERT_TRUE(save_data(model, folder / "one.vtk"));
  EXPECT_NE(std::string::npos, read_text(folder / "one.vtk").find("SPACE=LPS"));
  EXPECT_EQ(nullptr, model->GetPolyData()->GetFieldData()->GetAbstractArray("SPACE"));
}

TEST(ModelFileTest, TheFilesOwnFrameGoesBeforeTheNodes)
{
  const TemporaryFolder folder;
  vtkNew<vtkMRMLScene> scene;
  auto* model = add_model(scene, "skin");
  model->AddDefaultStorageNode();
  vtkMRMLModelStorageNode::SafeDownCast(model->GetStorageNode())
      ->SetCoordinateSystem(vtkMRMLStorageNode::CoordinateSystemRAS);
  for (const char* name : {"ras.vtp", "ras.vtk", "ras.stl", "ras.ply"})
  {
    ASSERT_TRUE(save_data(model, folder / name)) << name;
    auto* back = read_again<vtkMRMLModelNode>(scene, model); // assumes LPS
    ASSERT_NE(nullptr, back) << name;
    double expected[6];
    double bounds[6];
    model->GetRASBounds(expected);
    back->GetRASBounds(bounds);
    EXPECT_NEAR(expected[0], bounds[0], 1e-4) << name;
    EXPECT_NEAR(expected[2], bounds[2], 1e-4) << name;
  }
}

TEST(ModelFileTest, ArraysComeBackAsTheyWere)
{
  const TemporaryFolder folder;
  vtkNew<vtkMRMLScene> scene;
  auto* model = add_model(scene, "skin");
  const auto count = model->GetPolyData()->GetNumberOfPoints();
  vtkNew<vtkDoubleArray> displacement;
  displacement->SetName("displacement");
  displacement->SetNumberOfComponents(3);
  vtkNew<vtkDoubleArray> distances;
  distances->SetName("signed distance");
  for (vtkIdType i = 0; i < count; ++i)
  {
    displacement->InsertNextTuple3(1.0 / 3.0, 0.1 * static_cast<double>(i), -2.0);
    distances->InsertNextValue(std::sin(static_cast<double>(i)));
  }
  model->AddPointScalars(displacement);
  model->AddPointScalars(distances);
  for (const int compressed : {0, 1})
  {
    model->AddDefaultStorageNode();
    model->GetStorageNode()->SetUseCompression(compressed);
    ASSERT_TRUE(save_data(model, folder / "skin.vtp"));
    auto* back = read_again<vtkMRMLModelNode>(scene, model);
    ASSERT_NE(nullptr, back);
    ASSERT_TRUE(back->HasPointScalarName("displacement"));
    auto* moved = back->GetPolyData()->GetPointData()->GetArray("displacement");
    auto* far = back->GetPolyData()->GetPointData()->GetArray("signed distance");
    for (vtkIdType i = 0; i < count; ++i)
    {
      ASSERT_EQ(1.0 / 3.0, moved->GetComponent(i, 0))
          << "vectors that are not active are not turned";
      ASSERT_EQ(displacement->GetComponent(i, 1), moved->GetComponent(i, 1));
      ASSERT_EQ(distances->GetValue(i), far->GetComponent(i, 0));
    }
  }
}

TEST(ModelFileTest, UnstructuredGridsComeBack)
{
  const TemporaryFolder folder;
  vtkNew<vtkMRMLScene> scene;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int i = 0; i < 4; ++i)
  {
    points->InsertNextPoint(i == 1, (i == 2) + 0.1, 1.0 / 3.0 * (i == 3));
  }
  vtkNew<vtkUnstructuredGrid> grid;
  grid->SetPoints(points);
  const vtkIdType tetrahedron[] = {0, 1, 2, 3};
  grid->InsertNextCell(VTK_TETRA, 4, tetrahedron);
  auto* mesh = add_node<vtkMRMLModelNode>(scene, "mesh");
  mesh->SetAndObserveMesh(grid);
  EXPECT_EQ(vtkMRMLModelNode::UnstructuredGridMeshType, mesh->GetMeshType());
  EXPECT_EQ(nullptr, mesh->GetPolyData());
  ASSERT_TRUE(save_data(mesh, folder / "mesh.vtu"));
  auto* back = read_again<vtkMRMLModelNode>(scene, mesh);
  ASSERT_NE(nullptr, back);
  ASSERT_NE(nullptr, back->GetUnstructuredGrid());
  EXPECT_EQ(0.0, distance(grid, back->GetUnstructuredGrid()));
}

TEST(ModelFileTest, WrongFilesAreErrors)
{
  const QuietVtk quiet;
  const TemporaryFolder folder;
  vtkNew<vtkMRMLScene> scene;
  for (const char* name : {"a.vtp", "a.vtk", "a.stl", "a.xyz", "a.vtu"})
  {
    auto* model = add_node<vtkMRMLModelNode>(scene);
    model->AddDefaultStorageNode();
    model->GetStorageNode()->SetFileName(folder.write(name, "nonsense").c_str());
    EXPECT_EQ(0, model->GetStorageNode()->ReadData(model)) << name;
    EXPECT_NE("", model->GetStorageNode()->GetUserMessages()->GetAllMessagesAsString()) << name;
  }
  auto* model = add_model(scene, "skin");
  EXPECT_FALSE(save_data(model, folder / "no such folder/skin.vtp"));
  EXPECT_FALSE(save_data(model, folder / "skin.xyz"));
}

TEST(ModelFileTest, TheOldFileStaysWhereTheNewCannotBeWritten)
{
  const QuietVtk quiet;
  const TemporaryFolder folder;
  vtkNew<vtkMRMLScene> scene;
  auto* mesh = add_node<vtkMRMLModelNode>(scene, "mesh");
  vtkNew<vtkUnstructuredGrid> grid;
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.0, 0.0, 0.0);
  grid->SetPoints(points);
  mesh->SetAndObserveMesh(grid);
  folder.write("old.stl", "old");
  EXPECT_FALSE(save_data(mesh, folder / "old.stl")) << "a grid is no STL";
  EXPECT_EQ("old", read_text(folder / "old.stl"));
  EXPECT_EQ(1U, folder.file_count());
}

// --- Transforms --------------------------------------------------------------------------------

TEST(TransformTest, ChainsGoToTheWorldAndBetweenNodes)
{
  vtkNew<vtkMRMLScene> scene;
  auto* outer = add_node<vtkMRMLLinearTransformNode>(scene);
  auto* inner = add_node<vtkMRMLLinearTransformNode>(scene);
  vtkNew<vtkTransform> turn;
  turn->RotateZ(90.0);
  outer->SetMatrixTransformToParent(turn->GetMatrix());
  vtkNew<vtkTransform> shift;
  shift->Translate(10.0, 0.0, 0.0);
  inner->SetMatrixTransformToParent(shift->GetMatrix());
  ASSERT_TRUE(inner->SetAndObserveTransformNodeID(outer->GetID()));
  vtkNew<vtkMatrix4x4> toWorld;
  ASSERT_EQ(1, inner->GetMatrixTransformToWorld(toWorld));
  EXPECT_NEAR(10.0, toWorld->GetElement(1, 3), 1e-12);
  vtkNew<vtkMatrix4x4> between;
  vtkMRMLTransformNode::GetMatrixTransformBetweenNodes(inner, outer, between);
  EXPECT_NEAR(10.0, between->GetElement(0, 3), 1e-12);
  const double point[3] = {1.0, 0.0, 0.0};
  double world[3];
  auto* model = add_model(scene, "skin");
  model->SetAndObserveTransformNodeID(inner->GetID());
  model->TransformPointToWorld(point, world);
  EXPECT_NEAR(11.0, world[1], 1e-12);
  double local[3];
  model->TransformPointFromWorld(world, local);
  EXPECT_NEAR(1.0, local[0], 1e-12);
  const QuietVtk quiet;
  EXPECT_FALSE(outer->SetAndObserveTransformNodeID(inner->GetID())) << "no loops";
}

TEST(TransformTest, HardeningMovesTheData)
{
  vtkNew<vtkMRMLScene> scene;
  auto* move = add_node<vtkMRMLLinearTransformNode>(scene);
  vtkNew<vtkTransform> shift;
  shift->Translate(100.0, 0.0, 0.0);
  move->SetMatrixTransformToParent(shift->GetMatrix());
  auto* model = add_model(scene, "skin");
  double before[6];
  model->GetRASBounds(before);
  model->SetAndObserveTransformNodeID(move->GetID());
  double seen[6];
  model->GetRASBounds(seen);
  EXPECT_NEAR(before[0] + 100.0, seen[0], 1e-4);
  ASSERT_TRUE(model->HardenTransform());
  EXPECT_EQ(nullptr, model->GetParentTransformNode());
  double after[6];
  model->GetRASBounds(after);
  EXPECT_NEAR(seen[0], after[0], 1e-4);
}

class TransformFileTest : public ::testing::TestWithParam<const char*>
{
};

TEST_P(TransformFileTest, KeepsDoubles)
{
  const TemporaryFolder folder;
  vtkNew<vtkMRMLScene> scene;
  auto* move = add_node<vtkMRMLLinearTransformNode>(scene, "move");
  vtkNew<vtkTransform> transform;
  transform->Translate(1.0 / 3.0, -11.123456789012345, 5e-7);
  transform->RotateWXYZ(17.3, 0.2, -0.5, 0.8);
  move->SetMatrixTransformToParent(transform->GetMatrix());
  ASSERT_TRUE(save_data(move, folder / ("move ü." + std::string(GetParam()))));
  auto* back = read_again<vtkMRMLLinearTransformNode>(scene, move);
  ASSERT_NE(nullptr, back);
  vtkNew<vtkMatrix4x4> matrix;
  back->GetMatrixTransformToParent(matrix);
  for (int i = 0; i < 16; ++i)
  {
    EXPECT_NEAR(transform->GetMatrix()->GetElement(i / 4, i % 4), matrix->GetElement(i / 4, i % 4),
                1e-14 * (1.0 + std::abs(transform->GetMatrix()->GetElement(i / 4, i % 4))));
  }
  EXPECT_EQ(1U, folder.file_count());
}

INSTANTIATE_TEST_SUITE_P(Formats, TransformFileTest, ::testing::Values("tfm", "h5", "txt"));

TEST(TransformFileTest, HoldsTheWayFromTheParentInLps)
{
  const TemporaryFolder folder;
  vtkNew<vtkMRMLScene> scene;
  auto* move = add_node<vtkMRMLLinearTransformNode>(scene, "move");
  vtkNew<vtkTransform> shift;
  shift->Translate(1.0, 2.0, 3.0);
  move->SetMatrixTransformToParent(shift->GetMatrix());
  ASSERT_TRUE(save_data(move, folder / "move.tfm"));
  const std::string text = read_text(folder / "move.tfm");
  EXPECT_NE(std::string::npos, text.find("AffineTransform_double_3_3"));
  EXPECT_NE(std::string::npos, text.find("Parameters: 1 0 0 0 1 0 0 0 1 1 2 -3")) << text;
}

TEST(TransformFileTest, WrongFilesAreErrors)
{
  const QuietVtk quiet;
  const TemporaryFolder folder;
  vtkNew<vtkMRMLScene> scene;
  const std::string head = "#Insight Transform File V1.0\n#Transform 0\nTransform: ";
  for (const std::string& text :
       {std::string("nonsense"),
        head + "NoSuchTransform_double_3_3\nParameters: 1\nFixedParameters: 0\n",
        head + "AffineTransform_double_3_3\nParameters: 0 0 0 0 0 0 0 0 0 0 0 0\nFixedParameters: "
               "0 0 0\n",
        head + "AffineTransform_double_2_2\nParameters: 1 0 0 1 0 0\nFixedParameters: 0 0\n"})
  {
    auto* move = add_node<vtkMRMLLinearTransformNode>(scene);
    move->AddDefaultStorageNode();
    move->GetStorageNode()->SetFileName(folder.write("bad.tfm", text).c_str());
    EXPECT_EQ(0, move->GetStorageNode()->ReadData(move)) << text;
  }
}

// --- Volumes -----------------------------------------------------------------------------------

class VolumeFileTest : public ::testing::TestWithParam<const char*>
{
};

TEST_P(VolumeFileTest, VoxelsAndGeometryComeBack)
{
  const TemporaryFolder folder;
  vtkNew<vtkMRMLScene> scene;
  auto* ct = add_node<vtkMRMLScalarVolumeNode>(scene, "CT");
  vtkNew<vtkImageData> image;
  image->SetDimensions(5, 4, 3);
  image->AllocateScalars(VTK_SHORT, 1);
  auto* voxels = static_cast<short*>(image->GetScalarPointer());
  for (int i = 0; i < 60; ++i)
  {
    voxels[i] = static_cast<short>(37 * i - 1000);
  }
  ct->SetAndObserveImageData(image);
  vtkNew<vtkTransform> geometry;
  geometry->Translate(-12.5, 30.25, 100.0);
  geometry->RotateZ(20.0);
  geometry->Scale(0.5, 0.5, 1.25);
  ct->SetIJKToRASMatrix(geometry->GetMatrix());
  ASSERT_TRUE(save_data(ct, folder / ("ct ü." + std::string(GetParam()))));
  auto* back = read_again<vtkMRMLScalarVolumeNode>(scene, ct);
  ASSERT_NE(nullptr, back);
  ASSERT_NE(nullptr, back->GetImageData());
  EXPECT_EQ(VTK_SHORT, back->GetImageData()->GetScalarType());
  EXPECT_EQ(1.0, back->GetImageData()->GetSpacing()[2]) << "the node has the geometry";
  EXPECT_EQ(0.0, back->GetImageData()->GetOrigin()[2]);
  EXPECT_TRUE(std::equal(voxels, voxels + 60,
                         static_cast<short*>(back->GetImageData()->GetScalarPointer())));
  vtkNew<vtkMatrix4x4> matrix;
  back->GetIJKToRASMatrix(matrix);
  for (int i = 0; i < 16; ++i)
  {
    // NIfTI keeps floats.
    EXPECT_NEAR(geometry->GetMatrix()->GetElement(i / 4, i % 4), matrix->GetElement(i / 4, i % 4),
                1e-4);
  }
  EXPECT_EQ(1U, folder.file_count());
}

INSTANTIATE_TEST_SUITE_P(Formats, VolumeFileTest,
                         ::testing::Values("nrrd", "mha", "nii", "nii.gz"));

TEST(VolumeFileTest, WrongFilesAreErrors)
{
  const QuietVtk quiet;
  const TemporaryFolder folder;
  vtkNew<vtkMRMLScene> scene;
  const std::string head = "NRRD0004\ntype: short\ndimension: 3\nencoding: raw\nendian: little\n";
  for (const std::string& text : {std::string("nonsense"), head + "sizes: 100000 100000 100000\n\n",
                                  head + "sizes: 4 4 4\n\n", head + "sizes: 0 4 4\n\n"})
  {
    auto* ct = add_node<vtkMRMLLabelMapVolumeNode>(scene);
    ct->AddDefaultStorageNode();
    ct->GetStorageNode()->SetFileName(folder.write("bad.nrrd", text).c_str());
    EXPECT_EQ(0, ct->GetStorageNode()->ReadData(ct)) << text;
  }
}

// --- Colours -----------------------------------------------------------------------------------

TEST(ColorTableTest, ComesBackFromItsFile)
{
  const TemporaryFolder folder;
  vtkNew<vtkMRMLScene> scene;
  auto* table = add_node<vtkMRMLColorTableNode>(scene, "diverging");
  table->SetTypeToUser();
  table->SetNumberOfColors(3);
  table->SetColor(0, "far behind", 0.0, 0.0, 1.0);
  table->SetColor(1, "on it", 1.0, 1.0, 1.0);
  table->SetColor(2, "before", 1.0 / 3.0, 0.0, 0.0, 0.5);
  ASSERT_TRUE(save_data(table, folder / "diverging.ctbl"));
  auto* back = read_again<vtkMRMLColorTableNode>(scene, table);
  ASSERT_NE(nullptr, back);
  ASSERT_EQ(3, back->GetNumberOfColors());
  EXPECT_STREQ("far behind", back->GetColorName(0));
  double color[4];
  ASSERT_TRUE(back->GetColor(2, color));
  EXPECT_NEAR(1.0 / 3.0, color[0], 1.0 / 255.0);
  EXPECT_NEAR(0.5, color[3], 1.0 / 255.0);
}

#include "expect_error.hpp"
#include "temporary_folder.hpp"

#include <Bridge/grid_file.hpp>

namespace f2b
{
namespace
{

using test::expect_error;
using test::TemporaryFolder;

template <class Grid>
Grid numbered_grid()
{
  Grid grid;
  grid.origin = {-12.3, 4.56, 1.0 / 3};
  grid.spacing = 1.1;
  grid.size = {5, 4, 3};
  for (std::size_t i = 0; i < grid.count(); ++i)
    grid.values.push_back(static_cast<typename decltype(grid.values)::value_type>(i * 4));
  return grid;
}

TEST(GridFile, DistancesComeBackExactly)
{
  const TemporaryFolder folder;
  const auto grid = numbered_grid<ScalarGrid>();
  write_grid(folder / "d.nrrd", grid);
  const ScalarGrid read = read_scalar_grid(folder / "d.nrrd");
  EXPECT_TRUE(read.same_lattice(grid));
  EXPECT_EQ(read.values, grid.values);
}

TEST(GridFile, LabelsComeBackExactly)
{
  const TemporaryFolder folder;
  const auto grid = numbered_grid<LabelGrid>();
  write_grid(folder / "l.nrrd", grid);
  const LabelGrid read = read_label_grid(folder / "l.nrrd");
  EXPECT_EQ(read.origin, grid.origin);
  EXPECT_EQ(read.size, grid.size);
  EXPECT_EQ(read.spacing, grid.spacing);
  EXPECT_EQ(read.values, grid.values);
}

TEST(GridFile, FilesSayTheirFrame)
{
  const TemporaryFolder folder;
  write_grid(folder / "d.nrrd", numbered_grid<ScalarGrid>());
  const std::string text = test::read_text(folder / "d.nrrd").substr(0, 600);
  EXPECT_NE(text.find("left-posterior-superior"), std::string::npos) << text;
  EXPECT_NE(text.find("space directions: (-1."), std::string::npos) << text;
  EXPECT_NE(text.find("space origin: (12."), std::string::npos) << text;
}

TEST(GridFile, DamagedAndForeignFilesAreRefused)
{
  const TemporaryFolder folder;
  write_grid(folder / "d.nrrd", numbered_grid<ScalarGrid>());
  write_grid(folder / "l.nrrd", numbered_grid<LabelGrid>());
  for (const char* name : {"d.nrrd", "l.nrrd"})
  {
    const std::string whole = test::read_text(folder / name);
    for (const std::string& text :
         {std::string(), std::string("junk"), whole.substr(0, whole.size() - 20)})
    {
      folder.write(name, text);
      expect_error(
          [&] {
            name[0] == 'd' ? (void)read_scalar_grid(folder / name)
                           : (void)read_label_grid(folder / name);
          },
          {name, "segment"});
    }
  }
  const auto skewed =
      folder.write("skewed.nrrd", "NRRD0004\ntype: float\ndimension: 3\n"
                                  "space: left-posterior-superior\nsizes: 1 1 1\n"
                                  "space directions: (1,0,0) (0,1,0) (0,0,2)\nendian: little\n"
                                  "encoding: raw\nspace origin: (0,0,0)\n\n1234");
  expect_error([&] { read_scalar_grid(skewed); }, {skewed.string(), "axes"});
  expect_error([&] { read_scalar_grid(folder / "absent.nrrd"); }, {"absent.nrrd"});
  expect_error([&] { write_grid("/proc/x.nrrd", numbered_grid<ScalarGrid>()); },
               {"/proc/x.nrrd", "written"});
}

} // namespace
} // namespace f2b

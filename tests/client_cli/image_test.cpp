#include "client_cli/draw/image.hpp"

#include <cairo.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <cmath>
#include <filesystem>
#include <functional>

#include "client_cli/command.hpp"
#include "tests/client_cli/picture_fixture.hpp"

namespace breakshot::client {
namespace {

using physics::Vec2;

int distance(Rgb a, Rgb b) {
  return std::abs(a.red - b.red) + std::abs(a.green - b.green) + std::abs(a.blue - b.blue);
}

Rgb pixel_at(const Image& image, const Picture& picture, Vec2 metres) {
  const View view(world_of(picture), image.width, image.height);
  const Vec2 pixel = view.pixel_of(metres);
  return image.at(static_cast<int>(pixel.x), static_cast<int>(pixel.y));
}

/// Every pixel of the image with its place in metres.
void for_each_pixel(const Image& image, const Picture& picture,
                    const std::function<void(Vec2, Rgb)>& visit) {
  const Box world = world_of(picture);
  const double scale = View(world, image.width, image.height).px_per_m();
  const Vec2 centre = (world.low + world.high) / 2.0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const Vec2 from_middle{x + 0.5 - image.width / 2.0, image.height / 2.0 - y - 0.5};
      visit(centre + from_middle / scale, image.at(x, y));
    }
  }
}

Image default_image(const Picture& picture, Detail detail) {
  return image_of(picture, size_for_width(picture, 800), detail);
}

class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& name)
      : path_(std::filesystem::path(testing::TempDir()) / name) {}
  ~TemporaryFile() { std::filesystem::remove(path_); }
  std::string path() const { return path_.string(); }

 private:
  std::filesystem::path path_;
};

TEST(Image, ShowsEachBallInItsColourAtItsPlace) {
  Picture picture = empty_picture();
  for (std::uint32_t id = 0; id < 16; ++id) {
    picture.balls.push_back(ball_at(id, {-1.0 + id * 0.13, 0.3 * std::sin(2.3 * id)}));
  }
  const Image image = default_image(picture, Detail::full);
  const double radius = picture.table.ball_radius_m;
  for (const DrawnBall& ball : picture.balls) {
    // Below the highlight and beside the number.
    const Vec2 place = ball.position + Vec2{0.62 * radius, -0.1 * radius};
    EXPECT_LT(distance(pixel_at(image, picture, place), colour_of(ball.id)), 150)
        << number(ball.id);
    EXPECT_LT(distance(pixel_at(image, picture, ball.position + Vec2{0, 0.1}), palette::cloth), 40);
  }
}

TEST(Image, ShowsStripesAsIvoryAboveAndBelowTheirBand) {
  Picture picture = empty_picture();
  picture.balls = {ball_at(10, {0.2, 0.1}), ball_at(2, {-0.2, 0.1})};
  const Image image = default_image(picture, Detail::full);
  const Vec2 below{0, -0.75 * picture.table.ball_radius_m};
  const Rgb striped = pixel_at(image, picture, Vec2{0.2, 0.1} + below);
  const Rgb solid = pixel_at(image, picture, Vec2{-0.2, 0.1} + below);
  EXPECT_GT(striped.red, 130);
  EXPECT_LT(solid.red, 60);
}

TEST(Image, ABallChangesNothingOutsideItsShadow) {
  const Picture before = empty_picture();
  Picture after = before;
  const Vec2 place{0.31, -0.17};
  after.balls = {ball_at(3, place)};
  const Image without = default_image(before, Detail::full);
  const Image with = default_image(after, Detail::full);
  std::size_t changed = 0;
  std::size_t i = 0;
  for_each_pixel(with, after, [&](Vec2 where, Rgb pixel) {
    if (pixel == without.pixels[i++]) return;
    ++changed;
    EXPECT_LT(physics::length(where - place), 1.7 * after.table.ball_radius_m);
  });
  EXPECT_GT(changed, 100u);
}

TEST(Image, NothingIsDrawnOutsideTheFrame) {
  Picture picture = racked_picture();
  picture.cue = CueVector{{1, 0}, {1, 0}, 13};
  picture.velocities = true;
  picture.balls[3].velocity = {0, 20};
  const Image image = default_image(picture, Detail::full);
  const Box frame = frame_of(picture.table);
  const double pixel = 1 / View(world_of(picture), image.width, image.height).px_per_m();
  for_each_pixel(image, picture, [&](Vec2 where, Rgb colour) {
    const bool inside = where.x > frame.low.x - pixel && where.x < frame.high.x + pixel &&
                        where.y > frame.low.y - pixel && where.y < frame.high.y + pixel;
    if (!inside) {
      EXPECT_EQ(colour, palette::background) << where.x << ' ' << where.y;
    }
  });
}

TEST(Image, AMirroredTableGivesTheMirroredPicture) {
  // Coarse pictures have no light from one side and no numbers, so they must mirror exactly.
  Picture picture = empty_picture();
  Picture mirrored = picture;
  picture.velocities = mirrored.velocities = true;
  for (std::uint32_t id = 0; id < 16; ++id) {
    const Vec2 place{-1.0 + id * 0.13, 0.3 * std::sin(2.3 * id)};
    const Vec2 velocity{std::cos(1.0 * id), std::sin(1.0 * id)};
    picture.balls.push_back(ball_at(id, place, velocity));
    mirrored.balls.push_back(ball_at(id, {place.x, -place.y}, {velocity.x, -velocity.y}));
  }
  const PixelSize size = size_for_width(picture, 400);
  const Image one = image_of(picture, size, Detail::coarse);
  const Image other = image_of(mirrored, size, Detail::coarse);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      ASSERT_LE(distance(one.at(x, y), other.at(x, size.height - 1 - y)), 24) << x << ' ' << y;
    }
  }
}

TEST(Picture, DrawsAnArcAsChordsWithTheTableToTheirLeft) {
  physics::Scene scene;
  physics::FreeCushions cushions;
  cushions.arcs.push_back({{1, 2}, 0.5, {0, -1}, {1, 0}, physics::Mirror{}});
  scene.cushions = cushions;
  const Table table = table_of(scene);
  ASSERT_GT(table.cushions.size(), 8u);
  EXPECT_LT(physics::length(table.cushions.front().to - Vec2{1, 1.5}), 1e-12);
  EXPECT_LT(physics::length(table.cushions.back().from - Vec2{1.5, 2}), 1e-12);
  for (const auto& chord : table.cushions) {
    const Vec2 along = chord.to - chord.from;
    EXPECT_LT(physics::cross(along, Vec2{1, 2} - chord.from), 0) << "the centre is on the right";
  }
}

TEST(Image, PathsAndVectorsAreSeenWhereTheyLie) {
  Picture picture = empty_picture();
  picture.balls = {ball_at(0, {0.3, 0.2}, {0, -2})};
  picture.velocities = true;
  picture.cue = CueVector{{-0.5, 0.2}, {1, 0}, 5};
  picture.paths = {{physics::BallId{1}, {{-0.5, -0.3}, {0.5, -0.3}}}};
  const Image image = default_image(picture, Detail::full);
  EXPECT_LT(distance(pixel_at(image, picture, {-0.4, 0.2}), palette::cue_vector), 60);
  EXPECT_LT(distance(pixel_at(image, picture, {0.3, 0.1}), palette::velocity), 60);
  EXPECT_LT(distance(pixel_at(image, picture, {0, -0.3}), colour_of(physics::BallId{1})), 200);
  EXPECT_GT(distance(pixel_at(image, picture, {0, -0.3}), palette::cloth), 200);
}

TEST(Image, APngDecodesToThePixelsThatWereDrawn) {
  const TemporaryFile file("breakshot_image_test.png");
  const Picture picture = racked_picture();
  const PixelSize size{300, 180};
  write_picture(picture, size, file.path());
  cairo_surface_t* surface = cairo_image_surface_create_from_png(file.path().c_str());
  ASSERT_EQ(cairo_surface_status(surface), CAIRO_STATUS_SUCCESS);
  EXPECT_EQ(cairo_image_surface_get_width(surface), size.width);
  EXPECT_EQ(cairo_image_surface_get_height(surface), size.height);
  const Image image = image_of(picture, size);
  const unsigned char* data = cairo_image_surface_get_data(surface);
  const int stride = cairo_image_surface_get_stride(surface);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      std::uint32_t pixel = 0;
      std::memcpy(&pixel, data + y * stride + 4 * x, sizeof pixel);
      const Rgb expected = image.at(x, y);
      ASSERT_EQ(pixel & 0xffffff, std::uint32_t{expected.red} << 16 |
                                      std::uint32_t{expected.green} << 8 |
                                      std::uint32_t{expected.blue});
    }
  }
  cairo_surface_destroy(surface);
}

std::size_t paths_in(const boost::property_tree::ptree& node) {
  std::size_t count = 0;
  for (const auto& [name, child] : node) count += (name == "path" ? 1 : 0) + paths_in(child);
  return count;
}

TEST(Image, AnSvgIsWellFormedAndHasTheSizeAskedFor) {
  const TemporaryFile file("breakshot_image_test.svg");
  write_picture(racked_picture(), {640, 400}, file.path());
  boost::property_tree::ptree document;
  boost::property_tree::read_xml(file.path(), document);
  EXPECT_EQ(document.get<std::string>("svg.<xmlattr>.viewBox"), "0 0 640 400");
  // At least a path and a number for each of fifteen balls.
  EXPECT_GT(paths_in(document.get_child("svg")), 30u);
}

TEST(Image, SaysWhichFileCannotBeWrittenAndWhy) {
  const Picture picture = empty_picture();
  for (const char* file : {"/nonexistent/a.png", "/nonexistent/a.svg"}) {
    try {
      write_picture(picture, {64, 64}, file);
      FAIL() << file;
    } catch (const CommandError& error) {
      EXPECT_EQ(std::string(error.what()).rfind(file, 0), 0u) << error.what();
      EXPECT_EQ(error.status(), exit_failed);
    }
  }
  EXPECT_THROW(write_picture(picture, {64, 64}, "picture.bmp"), CommandError);
}

TEST(Image, TakesAnyShapeAndKeepsTheTableCentred) {
  const Picture picture = empty_picture();
  for (const PixelSize size : {PixelSize{16, 16}, PixelSize{900, 100}, PixelSize{100, 900}}) {
    const Image image = image_of(picture, size);
    EXPECT_LT(distance(image.at(size.width / 2, size.height / 2), palette::cloth), 60);
  }
}

}  // namespace
}  // namespace breakshot::client

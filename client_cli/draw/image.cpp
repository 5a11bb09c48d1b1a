#include "client_cli/draw/image.hpp"

#include <cairo-svg.h>

#include <cerrno>
#include <cmath>
#include <cstring>
#include <memory>

#include "client_cli/command.hpp"
#include "client_cli/draw/paint.hpp"

namespace breakshot::client {
namespace {

using physics::Vec2;
using SurfacePtr = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;
using ContextPtr = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;

bool has_footer(const Picture& picture) {
  return !picture.caption.empty() || !picture.pocketed.empty();
}

double footer_height(const Picture& picture) {
  return has_footer(picture) ? 3.2 * picture.table.ball_radius_m : 0;
}

double margin(const Picture& picture) {
  return 0.9 * picture.table.ball_radius_m;
}

/// The line of text at the left and the balls that are down at the right.
void paint_footer(Canvas& canvas, const Picture& picture) {
  const Box frame = frame_of(picture.table);
  const double radius = picture.table.ball_radius_m;
  const double y = frame.low.y - footer_height(picture) / 2 - 0.2 * radius;
  const double pitch = 2.4 * radius;
  const double width = pitch * static_cast<double>(picture.pocketed.size());
  if (width > 0) {
    const Vec2 half{0, 1.3 * radius};
    const Vec2 right{frame.high.x, y};
    canvas.rounded({right - Vec2{width, 0} - half, right + half}, half.y);
    canvas.fill(palette::wood_dark);
  }
  double x = frame.high.x - pitch / 2;
  for (auto ball = picture.pocketed.rbegin(); ball != picture.pocketed.rend(); ++ball) {
    paint_ball(canvas, *ball, {x, y}, radius);
    x -= pitch;
  }
  if (!picture.caption.empty()) {
    canvas.text_from(picture.caption, {frame.low.x + 0.5 * radius, y}, 1.5 * radius,
                     palette::caption);
  }
}

void paint(cairo_t* context, const Picture& picture, const Box& world, PixelSize size,
           Detail detail) {
  Canvas canvas(context, View(world, size.width, size.height), detail);
  canvas.everywhere();
  canvas.fill(palette::background);
  paint_table(canvas, picture.table);
  canvas.save();
  canvas.rectangle(frame_of(picture.table));
  canvas.clip();
  paint_paths(canvas, picture);
  paint_balls(canvas, picture);
  paint_vectors(canvas, picture);
  canvas.restore();
  if (canvas.full()) paint_footer(canvas, picture);
}

[[noreturn]] void fail(const std::string& file, cairo_status_t status) {
  const std::string why = status == CAIRO_STATUS_WRITE_ERROR && errno != 0
                              ? std::strerror(errno)
                              : cairo_status_to_string(status);
  throw CommandError(file + ": cannot be written: " + why);
}

void check(cairo_status_t status, const std::string& file) {
  if (status != CAIRO_STATUS_SUCCESS) fail(file, status);
}

SurfacePtr pixels_of(const Picture& picture, const Box& world, PixelSize size, Detail detail) {
  SurfacePtr surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, size.width, size.height),
                     cairo_surface_destroy);
  const ContextPtr context(cairo_create(surface.get()), cairo_destroy);
  cairo_set_antialias(context.get(), CAIRO_ANTIALIAS_BEST);
  paint(context.get(), picture, world, size, detail);
  cairo_surface_flush(surface.get());
  return surface;
}

void write_svg(const Picture& picture, PixelSize size, const std::string& file) {
  const SurfacePtr surface(cairo_svg_surface_create(file.c_str(), size.width, size.height),
                           cairo_surface_destroy);
  check(cairo_surface_status(surface.get()), file);
  cairo_svg_surface_set_document_unit(surface.get(), CAIRO_SVG_UNIT_PX);
  const ContextPtr context(cairo_create(surface.get()), cairo_destroy);
  paint(context.get(), picture, world_of(picture), size, Detail::full);
  cairo_surface_finish(surface.get());
  check(cairo_surface_status(surface.get()), file);
}

bool ends_with(const std::string& text, const std::string& ending) {
  return text.size() > ending.size() &&
         text.compare(text.size() - ending.size(), ending.size(), ending) == 0;
}

}  // namespace

Box world_of(const Picture& picture) {
  if (picture.window) return *picture.window;
  Box world = frame_of(picture.table);
  const Vec2 space{margin(picture), margin(picture)};
  world = {world.low - space, world.high + space};
  world.low.y -= footer_height(picture);
  return world;
}

PixelSize size_for_width(const Picture& picture, int width_px) {
  const Box world = world_of(picture);
  const double height = std::ceil(width_px * world.height() / world.width());
  return {width_px, static_cast<int>(height)};
}

Image image_of(const Picture& picture, PixelSize size, Detail detail) {
  return image_of(picture, world_of(picture), size, detail);
}

Image image_of(const Picture& picture, const Box& world, PixelSize size, Detail detail) {
  const SurfacePtr surface = pixels_of(picture, world, size, detail);
  Image image{size.width, size.height, {}};
  image.pixels.reserve(static_cast<std::size_t>(size.width) *
                       static_cast<std::size_t>(size.height));
  const unsigned char* data = cairo_image_surface_get_data(surface.get());
  const int stride = cairo_image_surface_get_stride(surface.get());
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      std::uint32_t pixel = 0;
      std::memcpy(&pixel, data + y * stride + x * 4, sizeof pixel);
      image.pixels.push_back({static_cast<std::uint8_t>(pixel >> 16),
                              static_cast<std::uint8_t>(pixel >> 8),
                              static_cast<std::uint8_t>(pixel)});
    }
  }
  return image;
}

void write_picture(const Picture& picture, PixelSize size, const std::string& file) {
  if (ends_with(file, ".svg")) {
    write_svg(picture, size, file);
  } else if (ends_with(file, ".png")) {
    const SurfacePtr surface = pixels_of(picture, world_of(picture), size, Detail::full);
    check(cairo_surface_write_to_png(surface.get(), file.c_str()), file);
  } else {
    throw CommandError(file + ": the name of a picture ends in .png or .svg", exit_usage);
  }
}

}  // namespace breakshot::client

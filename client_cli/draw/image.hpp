// Pictures through Cairo: pixels in memory, PNG and SVG files.
#pragma once

#include <string>
#include <vector>

#include "client_cli/draw/canvas.hpp"
#include "client_cli/draw/picture.hpp"

namespace breakshot::client {

/// Pixels in rows from the top.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<Rgb> pixels;

  Rgb at(int x, int y) const {
    return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x)];
  }
};

struct PixelSize {
  int width = 0;
  int height = 0;

  friend bool operator==(const PixelSize&, const PixelSize&) = default;
};

inline constexpr int default_width_px = 1600;
inline constexpr int min_side_px = 16;
inline constexpr int max_side_px = 16384;

/// What a picture shows, in metres: the table with a margin, and room for the line and the pocketed
/// balls under it.
Box world_of(const Picture& picture);

/// The height that fits `width_px` without empty borders.
PixelSize size_for_width(const Picture& picture, int width_px);

/// Draws into memory; the world fills the image as far as its shape allows.
Image image_of(const Picture& picture, PixelSize size, Detail detail = Detail::full);
/// The same of another part of the world.
Image image_of(const Picture& picture, const Box& world, PixelSize size, Detail detail);

/// Writes a file, PNG or SVG by its ending (".png", ".svg"). Throws CommandError, which names the
/// file, where it cannot be written or the ending is another one.
void write_picture(const Picture& picture, PixelSize size, const std::string& file);

}  // namespace breakshot::client

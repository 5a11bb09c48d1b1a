// Cairo in metres: +x to the right and +y up, with the colours and shapes that the table is made
// of.
#pragma once

#include <cairo.h>

#include <initializer_list>
#include <memory>
#include <string>
#include <vector>

#include "client_cli/draw/palette.hpp"
#include "client_cli/draw/picture.hpp"
#include "common/physics/vec.hpp"

namespace breakshot::client {

/// How much of the table is worth drawing: `coarse` is for a few pixels a ball, flat and without
/// anything that would blur into noise.
enum class Detail { full, coarse };

/// From metres to pixels: `world` fills the pixels as far as its shape allows and is centred.
class View {
 public:
  View(const Box& world, double width_px, double height_px);

  double px_per_m() const { return scale_; }
  /// In pixels from the upper left corner, y downwards.
  physics::Vec2 pixel_of(physics::Vec2 metres) const;

 private:
  double scale_ = 1;
  physics::Vec2 centre_;
  physics::Vec2 middle_px_;
};

struct Stop {
  double at = 0;  ///< [0, 1]
  Rgb colour;
  double alpha = 1;
};

/// Draws on a Cairo context that somebody else owns and keeps alive.
class Canvas {
 public:
  Canvas(cairo_t* context, const View& view, Detail detail);
  ~Canvas();
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  bool full() const { return detail_ == Detail::full; }
  /// The size of a pixel, m: nothing thinner can be seen.
  double pixel_m() const { return 1 / px_per_m_; }

  // Paths.
  /// All that can be drawn on.
  void everywhere();
  void rectangle(const Box& box);
  void rounded(const Box& box, double radius_m);
  void circle(physics::Vec2 centre, double radius_m);
  void polygon(const std::vector<physics::Vec2>& points);
  void polyline(const std::vector<physics::Vec2>& points);

  // What becomes of the path. Lines are never thinner than a pixel.
  void fill(Rgb colour, double alpha = 1);
  void fill_linear(physics::Vec2 from, physics::Vec2 to, std::initializer_list<Stop> stops);
  void fill_radial(physics::Vec2 centre, double radius_m, std::initializer_list<Stop> stops);
  void stroke(Rgb colour, double width_m, double alpha = 1);
  void clip();

  void save();
  void restore();

  /// Bold text with the middle of its ink at `middle`.
  void text(const std::string& text, physics::Vec2 middle, double size_m, Rgb colour);
  /// Text that starts at `left`, level with it.
  void text_from(const std::string& text, physics::Vec2 left, double size_m, Rgb colour);

 private:
  void letters(const std::string& text, physics::Vec2 at, double size_m, Rgb colour, bool centred);

  cairo_t* cairo_;
  double px_per_m_;
  Detail detail_;
};

}  // namespace breakshot::client

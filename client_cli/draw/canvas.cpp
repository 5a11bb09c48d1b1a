#include "client_cli/draw/canvas.hpp"

#include <algorithm>
#include <numbers>

namespace breakshot::client {
namespace {

using physics::Vec2;
using PatternPtr = std::unique_ptr<cairo_pattern_t, decltype(&cairo_pattern_destroy)>;

constexpr double channel(std::uint8_t value) {
  return value / 255.0;
}

void add_stops(cairo_pattern_t* pattern, std::initializer_list<Stop> stops) {
  for (const Stop& stop : stops) {
    cairo_pattern_add_color_stop_rgba(pattern, stop.at, channel(stop.colour.red),
                                      channel(stop.colour.green), channel(stop.colour.blue),
                                      stop.alpha);
  }
}

}  // namespace

View::View(const Box& world, double width_px, double height_px)
    : scale_(std::min(width_px / world.width(), height_px / world.height())),
      centre_((world.low + world.high) / 2.0),
      middle_px_{width_px / 2, height_px / 2} {}

Vec2 View::pixel_of(Vec2 metres) const {
  const Vec2 from_centre = metres - centre_;
  return {middle_px_.x + from_centre.x * scale_, middle_px_.y - from_centre.y * scale_};
}

Canvas::Canvas(cairo_t* context, const View& view, Detail detail)
    : cairo_(context), px_per_m_(view.px_per_m()), detail_(detail) {
  cairo_save(cairo_);
  const Vec2 origin = view.pixel_of({0, 0});
  cairo_translate(cairo_, origin.x, origin.y);
  cairo_scale(cairo_, px_per_m_, -px_per_m_);
  cairo_set_line_join(cairo_, CAIRO_LINE_JOIN_ROUND);
  cairo_set_line_cap(cairo_, CAIRO_LINE_CAP_ROUND);
}

Canvas::~Canvas() {
  cairo_restore(cairo_);
}

void Canvas::everywhere() {
  double left = 0;
  double top = 0;
  double right = 0;
  double bottom = 0;
  cairo_clip_extents(cairo_, &left, &top, &right, &bottom);
  cairo_rectangle(cairo_, left, top, right - left, bottom - top);
}

void Canvas::rectangle(const Box& box) {
  cairo_rectangle(cairo_, box.low.x, box.low.y, box.width(), box.height());
}

void Canvas::rounded(const Box& box, double radius_m) {
  constexpr double quarter = std::numbers::pi / 2;
  const Vec2 low = box.low + Vec2{radius_m, radius_m};
  const Vec2 high = box.high - Vec2{radius_m, radius_m};
  cairo_new_sub_path(cairo_);
  cairo_arc(cairo_, high.x, low.y, radius_m, -quarter, 0);
  cairo_arc(cairo_, high.x, high.y, radius_m, 0, quarter);
  cairo_arc(cairo_, low.x, high.y, radius_m, quarter, 2 * quarter);
  cairo_arc(cairo_, low.x, low.y, radius_m, 2 * quarter, 3 * quarter);
  cairo_close_path(cairo_);
}

void Canvas::circle(Vec2 centre, double radius_m) {
  cairo_new_sub_path(cairo_);
  cairo_arc(cairo_, centre.x, centre.y, radius_m, 0, 2 * std::numbers::pi);
  cairo_close_path(cairo_);
}

void Canvas::polygon(const std::vector<Vec2>& points) {
  polyline(points);
  cairo_close_path(cairo_);
}

void Canvas::polyline(const std::vector<Vec2>& points) {
  cairo_new_sub_path(cairo_);
  for (const Vec2 point : points) cairo_line_to(cairo_, point.x, point.y);
}

void Canvas::fill(Rgb colour, double alpha) {
  cairo_set_source_rgba(cairo_, channel(colour.red), channel(colour.green), channel(colour.blue),
                        alpha);
  cairo_fill(cairo_);
}

void Canvas::fill_linear(Vec2 from, Vec2 to, std::initializer_list<Stop> stops) {
  const PatternPtr pattern(cairo_pattern_create_linear(from.x, from.y, to.x, to.y),
                           cairo_pattern_destroy);
  add_stops(pattern.get(), stops);
  cairo_set_source(cairo_, pattern.get());
  cairo_fill(cairo_);
}

void Canvas::fill_radial(Vec2 centre, double radius_m, std::initializer_list<Stop> stops) {
  const PatternPtr pattern(
      cairo_pattern_create_radial(centre.x, centre.y, 0, centre.x, centre.y, radius_m),
      cairo_pattern_destroy);
  add_stops(pattern.get(), stops);
  cairo_set_source(cairo_, pattern.get());
  cairo_fill(cairo_);
}

void Canvas::stroke(Rgb colour, double width_m, double alpha) {
  cairo_set_source_rgba(cairo_, channel(colour.red), channel(colour.green), channel(colour.blue),
                        alpha);
  cairo_set_line_width(cairo_, std::max(width_m, pixel_m()));
  cairo_stroke(cairo_);
}

void Canvas::clip() {
  cairo_clip(cairo_);
}

void Canvas::save() {
  cairo_save(cairo_);
}

void Canvas::restore() {
  cairo_restore(cairo_);
}

void Canvas::text(const std::string& text, Vec2 middle, double size_m, Rgb colour) {
  letters(text, middle, size_m, colour, true);
}

void Canvas::text_from(const std::string& text, Vec2 left, double size_m, Rgb colour) {
  letters(text, left, size_m, colour, false);
}

void Canvas::letters(const std::string& text, Vec2 at, double size_m, Rgb colour, bool centred) {
  cairo_save(cairo_);
  cairo_translate(cairo_, at.x, at.y);
  cairo_scale(cairo_, 1, -1);
  cairo_select_font_face(cairo_, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                         centred ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(cairo_, size_m);
  cairo_text_extents_t ink;
  cairo_text_extents(cairo_, centred ? text.c_str() : "0", &ink);
  const double x = centred ? -ink.x_bearing - ink.width / 2 : 0;
  cairo_move_to(cairo_, x, -ink.y_bearing - ink.height / 2);
  cairo_text_path(cairo_, text.c_str());
  fill(colour);
  cairo_restore(cairo_);
}

}  // namespace breakshot::client

// `breakshot render MATCH -o FILE`: a picture of any moment of any shot, or one of the paper's
// figures.
#include <charconv>

#include "client_cli/commands/commands.hpp"
#include "client_cli/draw/image.hpp"
#include "client_cli/figures.hpp"
#include "client_cli/online/match_name.hpp"
#include "client_cli/play_shot.hpp"
#include "client_cli/stored_match.hpp"
#include "client_cli/words.hpp"
#include "common/physics/table.hpp"

namespace breakshot::client {
namespace {

struct Options {
  std::string match;
  std::string name;
  std::uint32_t shot = 1;
  std::optional<double> time_s;
  std::string output;
  std::string size = std::to_string(default_width_px);
  std::optional<int> figure;
  std::string preset{physics::presets().front().name};
  Besides shown;
  bool caption = false;
};

std::optional<int> side_of(std::string_view text) {
  int side = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), side);
  const bool whole = error == std::errc{} && end == text.data() + text.size();
  if (!whole || side < min_side_px || side > max_side_px) return std::nullopt;
  return side;
}

/// WIDTH, with the height that fits, or WIDTHxHEIGHT.
PixelSize size_of(const std::string& text, const Picture& picture) {
  const std::size_t cross = text.find('x');
  const auto width = side_of(std::string_view(text).substr(0, cross));
  if (width && cross == std::string::npos) return size_for_width(picture, *width);
  if (width) {
    const auto height = side_of(std::string_view(text).substr(cross + 1));
    if (height) return {*width, *height};
  }
  throw CommandError("--size: " + text + ": must be WIDTH or WIDTHxHEIGHT, each from " +
                         std::to_string(min_side_px) + " to " + std::to_string(max_side_px),
                     exit_usage);
}

const physics::Scene& scene_of(const std::string& preset) {
  std::string known;
  for (const physics::Preset& each : physics::presets()) {
    if (each.name == preset) return each.scene;
    known += (known.empty() ? "" : ", ") + std::string(each.name);
  }
  throw CommandError("--preset: " + preset + ": is not one of " + known, exit_usage);
}

Picture picture_of(const StoredMatch& match, const Options& options) {
  const std::vector<StoredShot> shots = shots_of(match.record);
  const StoredShot& shot = shot_of(shots, options.shot);
  const physics::Timeline timeline(shot.shot());
  const double time_s = options.time_s.value_or(0);
  if (time_s > timeline.end_s()) {
    throw CommandError("--time: shot " + std::to_string(shot.number) + " ends at " +
                           std::to_string(timeline.end_s()) + " s",
                       exit_usage);
  }
  Picture picture;
  picture.table = table_of(match.record.header.settings.scene);
  picture.balls = balls_at(picture.table, timeline, time_s);
  if (options.shown.paths) picture.paths = paths_until(timeline, time_s);
  if (options.shown.cue) picture.cue = cue_vector_of(*shot.entry);
  picture.velocities = options.shown.velocities;
  if (!options.caption) return picture;
  const Names names = names_of(match.record.header);
  picture.caption = "Shot " + std::to_string(shot.number) + ": " +
                    command_text(shot.entry->author, shot.entry->command, shot.before, names);
  picture.pocketed = pocketed_by(shot.shot(), time_s, shot.pocketed);
  return picture;
}

int render(const Options& options, const Globals& globals) {
  if (options.time_s && !(*options.time_s >= 0)) {
    throw CommandError("--time: must be at least 0 s", exit_usage);
  }
  if (options.figure) {
    if (!options.match.empty()) {
      throw CommandError("--figure: draws no match; leave " + options.match + " out", exit_usage);
    }
    const Picture picture =
        figure(*options.figure, scene_of(options.preset), options.time_s, options.shown);
    write_picture(picture, size_of(options.size, picture), options.output);
    return exit_done;
  }
  if (options.match.empty()) {
    throw CommandError("render: needs a MATCH or --figure\nTry 'breakshot render --help'.",
                       exit_usage);
  }
  const StoredMatch match = open_match(options.match, globals, options.name);
  const Picture picture = picture_of(match, options);
  write_picture(picture, size_of(options.size, picture), options.output);
  if (match.damage) throw CommandError(options.match + ": " + damage_text(match));
  return exit_done;
}

}  // namespace

Command add_render(CLI::App& program, const Globals& globals) {
  auto options = std::make_shared<Options>();
  CLI::App* parser = program.add_subcommand(
      "render", "Draw any moment of any shot of a stored match, or one of the paper's figures");
  parser->add_option("MATCH", options->match,
                     "A .breakshot file, - for standard input, or the id of a match on the server");
  parser->add_option("-o,--output", options->output, "The picture to write")
      ->required()
      ->type_name("FILE.png|FILE.svg");
  add_guest_name(*parser, options->name);
  CLI::Option* const shot = parser->add_option("--shot", options->shot, "Which shot, from 1")
                                ->type_name("N")
                                ->capture_default_str();
  parser->add_option("--time", options->time_s, "Seconds since the start of the shot [0]")
      ->type_name("T");
  parser->add_option("--size", options->size, "Pixels; the height fits where it is left out")
      ->type_name("W[xH]")
      ->capture_default_str();
  parser->add_flag("--paths", options->shown.paths, "Draw the ways of the balls up to that moment");
  parser->add_flag("--vectors", options->shown.velocities, "Draw the balls' velocities in blue");
  parser->add_flag("--cue", options->shown.cue, "Draw the cue vector in red");
  CLI::Option* const caption =
      parser->add_flag("--caption", options->caption,
                       "Say under the table what is shown, with the balls that are down");
  parser
      ->add_option("--figure", options->figure,
                   "Draw a figure of the paper: 1 default layout, 2 rack, 3 break, 4 velocity "
                   "vectors")
      ->type_name("1|2|3|4")
      ->check(CLI::Range(1, figures))
      ->excludes(shot)
      ->excludes(caption);
  parser->add_option("--preset", options->preset, "The table of the figure")
      ->type_name("NAME")
      ->capture_default_str();
  parser->footer(
      "Exit status: 0; 1 the picture cannot be written, or the file is damaged (what is whole is\n"
      "drawn); 2 no such match, shot or moment.");
  return {parser, [options, &globals] { return render(*options, globals); }};
}

}  // namespace breakshot::client

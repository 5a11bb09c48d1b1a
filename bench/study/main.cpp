// `study`: measures what each method, number type and phenomenon costs and loses, and reports it.
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>

#include "bench/study/measure.hpp"
#include "bench/study/report.hpp"

namespace {

using namespace breakshot;

/// One line that is written over again on a terminal, one for each row elsewhere.
void show_progress(std::size_t done, std::size_t all, const std::string& next) {
  constexpr std::size_t width = 30;
  const std::size_t filled = width * done / std::max<std::size_t>(all, 1);
  const bool terminal = isatty(STDERR_FILENO) == 1;
  std::cerr << (terminal ? "\r\033[K[" : "[") << std::string(filled, '#')
            << std::string(width - filled, ' ') << "] " << done << " of " << all << "  " << next
            << (terminal && done < all ? "" : "\n") << std::flush;
}

struct Options {
  std::string data = "var/study";
  std::string page;
  std::string to;
  bool full = false;
  std::vector<std::string> words;
  std::size_t shots = 0;
};

void run_measure(const Options& options) {
  std::filesystem::create_directories(options.data);
  bench::StudyFiles files(options.data);
  bench::measure(files,
                 {options.full, std::filesystem::canonical("/proc/self/exe").parent_path().string(),
                  show_progress});
}

std::string text_of(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error(path + ": cannot be read");
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

void run_report(const Options& options) {
  const bench::StudyFiles files(options.data);
  const std::string page = bench::filled(text_of(options.page), files);
  std::ofstream(std::filesystem::path(options.to) / std::filesystem::path(options.page).filename())
      << page;
  std::ofstream(options.data + "/plots.gp") << bench::plots(files);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App program("What each method, number type and phenomenon costs and loses");
  program.require_subcommand(1);
  Options options;
  CLI::App* measure = program.add_subcommand(
      "measure", "Measure what is missing in the CSV files of a folder, and add it to them");
  measure->add_option("--data", options.data, "The folder")->capture_default_str();
  measure->add_flag("--full", options.full, "As many shots as a publication needs");
  CLI::App* report = program.add_subcommand(
      "report", "Fill the tables of a page from the CSV files; write plots.gp beside them");
  report->add_option("--data", options.data, "The folder of the files")->capture_default_str();
  report->add_option("--page", options.page, "The page with its tables marked")->required();
  report->add_option("--to", options.to, "The folder for the filled page")->required();
  CLI::App* simulate =
      program.add_subcommand("simulate", "Simulate and print nothing, for counting instructions");
  simulate->add_option("WAY", options.words, "SET METHOD SCALAR STEP, or SET VARIATION")
      ->expected(3, 5)
      ->required();
  CLI11_PARSE(program, argc, argv);
  try {
    if (measure->parsed()) run_measure(options);
    if (report->parsed()) run_report(options);
    if (simulate->parsed()) {
      options.shots = std::stoul(options.words.back());
      options.words.pop_back();
      bench::simulate_only(options.words, options.shots);
    }
  } catch (const std::exception& failure) {
    std::cerr << "study: " << failure.what() << '\n';
    return 1;
  }
  return 0;
}

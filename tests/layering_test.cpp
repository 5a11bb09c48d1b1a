// Which room may include which: the table below is the graph, and the sources are read to see that
// they keep to it. Linking alone does not: a header-only use of a wrong room links. The same walk
// keeps clocks, chance, unordered containers, input and output, and the mathematical functions that
// differ between platforms out of the rooms whose results must have the same bits everywhere.
#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tests/source_text.hpp"

namespace breakshot {
namespace {

using Names = std::set<std::string, std::less<>>;

/// What each room may include besides itself and the standard library: rooms by their folder,
/// libraries by the names of libraries(). `server` is the composition in main and config.
const std::map<std::string, Names, std::less<>>& graph() {
  static const std::map<std::string, Names, std::less<>> rooms = {
      {"common/hash", {"OpenSSL"}},
      {"common/physics", {}},
      {"common/rules", {"common/physics"}},
      {"common/match", {"common/physics", "common/rules", "common/hash"}},
      {"common/record", {"common/match", "common/rules", "common/physics", "common/hash"}},
      {"common/lobby",
       {"common/record", "common/match", "common/rules", "common/physics", "common/hash"}},
      {"common/wire",
       {"common/lobby", "common/record", "common/match", "common/rules", "common/physics",
        "common/hash", "proto", "protobuf", "JSON"}},
      {"common/study", {"common/physics", "Multiprecision"}},
      {"proto", {"protobuf"}},
      {"server/ledger",
       {"common/record", "common/match", "common/rules", "common/physics", "common/hash"}},
      {"server/hub",
       {"server/ledger", "common/lobby", "common/record", "common/match", "common/rules",
        "common/physics", "common/hash"}},
      {"server/store",
       {"server/ledger", "common/record", "common/match", "common/rules", "common/physics",
        "common/hash", "SQLite", "spdlog", "POSIX"}},
      {"server/net",
       {"server/hub", "common/wire", "common/lobby", "Asio", "OpenSSL", "spdlog", "POSIX"}},
      {"server/shell",
       {"server/hub", "server/net", "server/store", "server/ledger", "Asio", "spdlog", "POSIX"}},
      {"server",
       {"server/hub", "server/net", "server/store", "server/shell", "common/lobby", "Asio",
        "spdlog", "CLI11", "POSIX"}},
      {"client_cli",
       {"common/wire", "common/study", "common/lobby", "common/record", "common/match",
        "common/rules", "common/physics", "common/hash", "proto", "protobuf", "Asio", "Cairo",
        "CLI11", "spdlog", "POSIX"}},
      // A test or a benchmark may include whatever the rooms it names are built on.
      {"tests", {}},
      {"tests/hash", {"common/hash"}},
      {"tests/physics", {"common/physics"}},
      {"tests/rules", {"common/rules"}},
      {"tests/match", {"common/match"}},
      {"tests/record", {"common/record"}},
      {"tests/lobby", {"common/lobby"}},
      {"tests/wire", {"common/wire"}},
      {"tests/study", {"common/study"}},
      {"tests/hub", {"server/hub"}},
      {"tests/store", {"server/store"}},
      {"tests/net", {"server/net"}},
      {"tests/shell", {"server/shell"}},
      {"tests/client_cli", {"client_cli"}},
      {"tests/extremes", {"common/physics"}},
      {"tests/golden", {"common/wire"}},
      {"tests/simulation", {"server", "client_cli"}},
      {"tests/support", {"server", "client_cli"}},
      {"bench", {"server", "client_cli", "benchmark"}},
  };
  return rooms;
}

/// The first match tells the library of a header; a header of none of them is nobody's to include.
const std::vector<std::pair<std::string, std::string>>& libraries() {
  static const std::vector<std::pair<std::string, std::string>> prefixes = {
      {"boost/asio", "Asio"},
      {"boost/beast", "Asio"},
      {"boost/system/", "Asio"},
      {"boost/json/", "JSON"},
      {"boost/multiprecision/", "Multiprecision"},
      {"boost/property_tree/", "PropertyTree"},
      {"google/protobuf/", "protobuf"},
      {"breakshot/v1/", "proto"},
      {"spdlog/", "spdlog"},
      {"fmt/", "spdlog"},
      {"sqlite3", "SQLite"},
      {"openssl/", "OpenSSL"},
      {"cairo", "Cairo"},
      {"CLI/", "CLI11"},
      {"gtest/", "testing"},
      {"gmock/", "testing"},
      {"rapidcheck", "testing"},
      {"benchmark/", "benchmark"},
  };
  return prefixes;
}

/// The rooms whose results may depend on nothing but their arguments.
const Names& deterministic_rooms() {
  static const Names rooms = {"common/physics", "common/study", "common/rules", "common/match",
                              "common/record"};
  return rooms;
}

/// Standard headers that the deterministic rooms do without: unordered iteration, chance, clocks
/// and threads, input and output, and the locale that formatting by streams or printf reads.
const Names& indeterminate_headers() {
  static const Names headers = {
      "unordered_map", "unordered_set", "random", "chrono", "ctime",    "thread",  "future",
      "iostream",      "fstream",       "cstdio", "locale", "clocale",  "sstream", "iomanip",
      "filesystem",    "complex",       "atomic", "mutex",  "valarray", "regex",
  };
  return headers;
}

/// Functions of <cmath> whose results differ between libraries and processors, and the other
/// standard functions whose results differ between runs. sqrt is correctly rounded everywhere, and
/// those that only take numbers apart (abs, copysign, nextafter, floor ...) are exact.
const Names& indeterminate_functions() {
  static const Names functions = {
      "sin",  "cos",    "tan",    "asin",      "acos",   "atan",  "atan2",  "sinh",
      "cosh", "tanh",   "asinh",  "acosh",     "atanh",  "exp",   "exp2",   "expm1",
      "log",  "log2",   "log10",  "log1p",     "pow",    "hypot", "cbrt",   "fma",
      "erf",  "erfc",   "tgamma", "fmod",      "lgamma", "lerp",  "sincos", "remquo",
      "rand", "random", "srand",  "remainder", "time",   "clock", "getenv", "setlocale",
  };
  return functions;
}

/// A folder below common, server and tests is a room of its own, as is every other top folder;
/// deeper folders belong to their room. A file at the root is in no room.
std::string room_of(std::string_view path) {
  const auto first = path.find('/');
  if (first == std::string_view::npos) return {};
  const std::string_view top = path.substr(0, first);
  if (top != "common" && top != "server" && top != "tests") return std::string(top);
  const auto second = path.find('/', first + 1);
  return std::string(path.substr(0, second == std::string_view::npos ? first : second));
}

/// The room or library that a header belongs to; empty if it belongs to none that is known.
std::string owner_of(std::string_view header) {
  if (const std::string room = room_of(header); graph().contains(room)) return room;
  for (const auto& [prefix, library] : libraries()) {
    if (header.starts_with(prefix)) return library;
  }
  if (header.find_first_of("/.") == std::string_view::npos) return "standard";
  if (header.ends_with(".h") && !header.starts_with("boost/")) return "POSIX";
  return {};
}

void add_below(const std::string& name, Names& names) {
  if (!names.insert(name).second || !graph().contains(name)) return;
  for (const std::string& next : graph().at(name)) add_below(next, names);
}

/// All that a room may include, itself and the standard library among it.
Names allowed_in(const std::string& room) {
  Names names = {room, "standard"};
  if (!room.starts_with("tests") && room != "bench") {
    names.insert(graph().at(room).begin(), graph().at(room).end());
    return names;
  }
  for (const std::string& tested : graph().at(room)) add_below(tested, names);
  names.insert({"testing", "tests/support", "POSIX", "PropertyTree"});
  return names;
}

/// Everything that is wrong with one source, each as "path:line: what".
std::vector<std::string> faults_of(const Source& source) {
  const std::string room = room_of(source.path);
  if (!graph().contains(room)) return {source.path + ": its folder is not a room of the graph"};
  const Names allowed = allowed_in(room);
  const bool deterministic = deterministic_rooms().contains(room);
  const std::string code = code_of(source.text);
  std::vector<std::string> faults;
  const auto fault = [&](std::size_t line, const std::string& what) {
    faults.push_back(source.path + ":" + std::to_string(line) + ": " + what);
  };
  for (const auto& [line, header] : includes_of(code)) {
    const std::string owner = owner_of(header);
    if (owner.empty()) {
      fault(line, header + " is of no known room or library");
    } else if (!allowed.contains(owner)) {
      fault(line, room + " may not include " + header + " of " + owner);
    } else if (deterministic && indeterminate_headers().contains(header)) {
      fault(line, room + " must give the same bits everywhere, without <" + header + ">");
    }
  }
  if (!deterministic) return faults;
  for (const auto& [line, name] : standard_names_of(code)) {
    const bool suffixed = name.ends_with('f') || name.ends_with('l');  // sinf, sinl
    if (indeterminate_functions().contains(name) ||
        (suffixed && indeterminate_functions().contains(name.substr(0, name.size() - 1)))) {
      fault(line, name + " differs between platforms or runs");
    }
  }
  return faults;
}

TEST(Layering, SourcesKeepToTheGraph) {
  Names paths;
  for (const Source& source : sources_below(BREAKSHOT_SOURCE_DIR)) {
    paths.insert(source.path);
    for (const std::string& fault : faults_of(source)) ADD_FAILURE() << fault;
  }
  EXPECT_TRUE(paths.contains("common/physics/vec.hpp") && paths.contains("tests/layering_test.cpp"))
      << "the walk of " << BREAKSHOT_SOURCE_DIR << " found " << paths.size() << " sources";
}

TEST(Layering, GraphHasNoCycleAndNamesOnlyRoomsAndLibraries) {
  Names known = {"POSIX"};
  for (const auto& [prefix, library] : libraries()) known.insert(library);
  for (const auto& [room, included] : graph()) {
    for (const std::string& name : included) {
      EXPECT_TRUE(graph().contains(name) || known.contains(name)) << room << " -> " << name;
      Names below;
      add_below(name, below);
      EXPECT_FALSE(below.contains(room)) << room << " comes back to itself by " << name;
    }
  }
}

using Faults = std::vector<std::string>;

TEST(Layering, NamesAWrongInclude) {
  EXPECT_EQ(
      faults_of({"common/rules/facts.cpp", "\n#include \"common/match/match.hpp\"\n"}),
      Faults{"common/rules/facts.cpp:2: common/rules may not include common/match/match.hpp of "
             "common/match"});
  EXPECT_EQ(faults_of({"server/hub/hub.cpp", "#include <spdlog/spdlog.h>\n"}),
            Faults{"server/hub/hub.cpp:1: server/hub may not include spdlog/spdlog.h of spdlog"});
  const std::vector<std::pair<std::string, std::string>> wrong = {
      {"common/physics/a.cpp", "#include \"common/rules/facts.hpp\""},
      {"common/physics/a.cpp", "#include <math.h>"},
      {"common/physics/a.cpp", "#include \"vec.hpp\""},
      {"common/rules/a.cpp", "# include <vector>\n#  include <boost/asio.hpp>"},
      {"common/record/a.cpp", "#include <google/protobuf/message.h>"},
      {"common/match/a.cpp", "#include \"breakshot/v1/match.pb.h\""},
      {"common/wire/a.cpp", "#include \"server/hub/hub.hpp\""},
      {"common/wire/a.cpp", "#include <boost/asio/buffer.hpp>"},
      {"server/hub/a.cpp", "#include \"common/wire/frame.hpp\""},
      {"server/store/a.cpp", "#include <boost/asio.hpp>"},
      {"server/net/a.cpp", "#include <sqlite3.h>"},
      {"server/net/a.cpp", "#include \"server/store/store.hpp\""},
      {"client_cli/a.cpp", "#include \"server/hub/hub.hpp\""},
      {"client_cli/draw/a.cpp", "#include <sqlite3.h>"},
      {"common/hash/a.cpp", "#include <cairo.h>"},
      {"server/main.cpp",
       "#include <absl/strings/str_cat.h>\n#include <CLI/CLI.hpp>\n#include <a/b>"},
      {"tests/physics/a_test.cpp", "#include \"common/rules/facts.hpp\""},
  };
  for (const auto& [path, text] : wrong) {
    EXPECT_EQ(faults_of({path, text}).size(), 1u) << path << ": " << text;
  }
}

TEST(Layering, NamesAnUnknownRoom) {
  EXPECT_EQ(faults_of({"common/misc/a.hpp", ""}),
            Faults{"common/misc/a.hpp: its folder is not a room of the graph"});
  EXPECT_EQ(faults_of({"a.cpp", ""}), Faults{"a.cpp: its folder is not a room of the graph"});
  EXPECT_EQ(faults_of({"common/a.cpp", ""}).size(), 1u);
}

TEST(Layering, NamesWhatDiffersBetweenPlatformsOrRuns) {
  EXPECT_EQ(faults_of({"common/physics/a.cpp", "// why\ndouble y = std::sin(x);\n"}),
            Faults{"common/physics/a.cpp:2: sin differs between platforms or runs"});
  EXPECT_EQ(faults_of({"common/record/a.cpp", "#include <chrono>\n"}),
            Faults{"common/record/a.cpp:1: common/record must give the same bits everywhere, "
                   "without <chrono>"});
  for (const char* text :
       {"x = cos (y);", "using std::exp;", "x = ::pow(y, 2);", "x = std :: hypot(a, b);",
        "x = sqrt(atan2f(y, x));", "auto f = &std::cbrt;", "a = 1'000 * fmal(a, b, c);",
        "#include <unordered_map>", "#include <random>", "#include <thread>",
        "return time(nullptr);"}) {
    EXPECT_EQ(faults_of({"common/rules/a.cpp", text}).size(), 1u) << text;
    EXPECT_EQ(faults_of({"server/hub/a.cpp", text}).size(), 0u) << text;
  }
}

TEST(Layering, LetsRightSourcesBe) {
  const std::vector<std::pair<std::string, std::string>> right = {
      {"common/match/a.cpp", "#include \"common/rules/facts.hpp\"\n#include <vector>"},
      {"common/physics/a.cpp",
       "x = std::sqrt(y) + length(a) + shot.time + entry.log() + own::sin(z);\nReal time(Path p);"},
      {"common/physics/a.cpp",
       "// #include <random>\n/* std::sin(x) */ f(\"cos(\", 'x', R\"(pow()\");"},
      {"common/wire/a.cpp", "#include \"breakshot/v1/match.pb.h\"\n#include <random>"},
      {"client_cli/draw/a.cpp", "#include <cairo/cairo.h>\n#include \"common/wire/frame.hpp\""},
      {"server/net/a.cpp", "#include <boost/asio/ssl.hpp>\n#include \"server/hub/hub.hpp\""},
      {"tests/record/a_test.cpp", "#include <gtest/gtest.h>\n#include \"common/physics/vec.hpp\""},
      {"tests/simulation/a_test.cpp", "#include \"tests/support/b.hpp\"\n#include <sqlite3.h>"},
  };
  for (const auto& [path, text] : right) EXPECT_EQ(faults_of({path, text}), Faults{}) << text;
}

}  // namespace
}  // namespace breakshot

// A guest of the real server: remembers all that it has been told, and comes back after every loss
// of the connection.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "common/lobby/lobby.hpp"
#include "tests/support/line_client.hpp"

namespace breakshot::simulation {

using EntryPointer = std::shared_ptr<const record::Entry>;

/// The connection is gone; the guest can connect again.
struct Lost {};

class Guest {
 public:
  explicit Guest(std::string name) : name_(std::move(name)) {}

  /// Says hello, as a new guest at first and with the token from then on; follows the match again
  /// from where it was. Throws Lost.
  void connect(std::uint16_t port);
  void disconnect() { line_.reset(); }

  /// Asks and waits for the answer. `said` is called between the two. Throws Lost.
  lobby::Answer ask(const lobby::Request& request, const std::function<void()>& said = {});
  /// The same, if the answer must be an `Answer`.
  template <class Answer>
  Answer ask_for(const lobby::Request& request) {
    const lobby::Answer answer = ask(request);
    if (const auto* refused = std::get_if<lobby::Refused>(&answer)) {
      throw std::runtime_error("refused: " + refused->what);
    }
    return std::get<Answer>(answer);
  }

  void create(const lobby::Create& create) { news_ = ask_for<lobby::MatchNews>(create); }
  void join(match::MatchId match) {
    news_ = ask_for<lobby::MatchNews>(lobby::Join{match, std::nullopt, next()});
  }
  void join(const lobby::InviteCode& code) {
    news_ = ask_for<lobby::MatchNews>(lobby::Join{std::nullopt, code, next()});
  }
  void watch(match::MatchId match) {
    news_ = ask_for<lobby::MatchNews>(lobby::Watch{match, std::nullopt, next()});
  }

  /// Waits until entry `seq` has come. Throws Lost.
  void await(match::Seq seq);
  /// Waits for the server to close; the last words. Throws if there are none.
  lobby::Goodbye await_goodbye();

  const std::optional<lobby::MatchNews>& news() const { return news_; }
  match::MatchId match() const { return news_.value().info.id; }
  std::optional<match::Seat> seat() const { return news_.value().you; }
  /// All entries that were ever told, by number. That none is told in two ways is checked.
  const std::map<match::Seq, EntryPointer>& entries() const { return entries_; }
  /// The number of the entry after the last one that was told.
  match::Seq next() const;
  /// The match as this guest sees it: everything but the seed.
  match::Match view() const;
  void forget_match();

 private:
  lobby::Told hear();
  void keep(const lobby::EntryNews& news);

  std::string name_;
  std::optional<lobby::Token> token_;
  std::optional<support::LineClient> line_;
  std::optional<lobby::MatchNews> news_;
  std::map<match::Seq, EntryPointer> entries_;
};

}  // namespace breakshot::simulation

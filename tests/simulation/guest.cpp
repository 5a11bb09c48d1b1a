#include "tests/simulation/guest.hpp"

#include <stdexcept>
#include <system_error>
#include <utility>
#include <variant>

namespace breakshot::simulation {

void Guest::connect(std::uint16_t port) {
  line_.reset();
  line_.emplace(port);
  const auto welcome =
      ask_for<lobby::Welcome>(lobby::Hello{lobby::protocol_version, name_, token_});
  if (!token_) token_ = welcome.token.value();
  if (!news_) return;
  if (news_->you) {
    const auto seat = news_->you;
    join(match());
    if (news_->you != seat) throw std::runtime_error(name_ + " came back to another seat");
  } else {
    watch(match());
  }
}

lobby::Answer Guest::ask(const lobby::Request& request, const std::function<void()>& said) {
  if (!line_) throw Lost{};
  lobby::RequestId id{};
  try {
    id = line_->say(request);
  } catch (const std::system_error&) {
    throw Lost{};
  }
  if (said) said();
  while (true) {
    const lobby::Told told = hear();
    if (told.id == id) return told.answer;
  }
}

void Guest::await(match::Seq seq) {
  while (!entries_.contains(seq)) hear();
}

lobby::Goodbye Guest::await_goodbye() {
  std::optional<lobby::Goodbye> goodbye;
  while (const auto told = line_->hear()) {
    if (const auto* last = std::get_if<lobby::Goodbye>(&told->answer)) goodbye = *last;
  }
  line_.reset();
  if (!goodbye) throw std::runtime_error(name_ + " was told no goodbye");
  return *goodbye;
}

match::Seq Guest::next() const {
  if (entries_.empty()) return {};
  return match::Seq{static_cast<std::uint32_t>(entries_.rbegin()->first) + 1};
}

match::Match Guest::view() const {
  const match::Outcome& outcome = entries_.rbegin()->second->outcome;
  match::Match view;
  view.settings = news_.value().info.settings;
  view.next = next();
  view.table = outcome.table;
  view.status = outcome.status;
  return view;
}

void Guest::forget_match() {
  news_.reset();
  entries_.clear();
}

lobby::Told Guest::hear() {
  std::optional<lobby::Told> told;
  try {
    told = line_->hear();
  } catch (const std::system_error&) {
    // A connection that breaks in whatever way is lost.
  }
  if (!told) {
    line_.reset();
    throw Lost{};
  }
  if (const auto* entry = std::get_if<lobby::EntryNews>(&told->answer)) keep(*entry);
  if (const auto* news = std::get_if<lobby::MatchNews>(&told->answer)) {
    if (news_ && news->info.id == match()) news_ = *news;
  }
  return *std::move(told);
}

void Guest::keep(const lobby::EntryNews& news) {
  const auto [known, is_new] = entries_.emplace(news.entry->seq, news.entry);
  if (!is_new && !(*known->second == *news.entry)) {
    throw std::runtime_error(name_ + " was told an entry in two ways");
  }
}

}  // namespace breakshot::simulation

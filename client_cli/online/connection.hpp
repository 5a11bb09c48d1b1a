// One guest's conversation with a server, which survives the connection under it: when that is lost
// it is made again, the guest comes back to the match that it followed where it was, and a request
// that had no answer yet is asked again.
#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>

#include "client_cli/online/identity.hpp"
#include "client_cli/online/stream.hpp"
#include "client_cli/server_address.hpp"
#include "common/lobby/lobby.hpp"
#include "common/record/record.hpp"
#include "common/wire/frame.hpp"

namespace breakshot::client {

/// Who speaks. Without a store nobody remembers the guest: a stranger who only looks.
struct Guest {
  std::string name;
  std::optional<TokenStore> store;
};

/// How long to wait for what.
struct Patience {
  Milliseconds connect{10'000};   ///< for a connection to be made
  Milliseconds answer{20'000};    ///< for the next bytes while an answer is due
  Milliseconds quiet{20'000};     ///< without news before asking whether the server is there
  Milliseconds first_retry{200};  ///< before the first attempt to connect again; doubles
  Milliseconds longest_retry{5'000};
  Milliseconds give_up{600'000};  ///< after this much time without a connection
};

/// What is told about a followed match, in its order.
using EntryPtr = std::shared_ptr<const record::Entry>;
using News = std::variant<lobby::MatchNews, EntryPtr, lobby::MatchGone>;

class Connection {
 public:
  /// Told in plain words, for people, when the connection is lost and made again.
  using Notice = std::function<void(const std::string&)>;

  /// Connects and says hello. CommandError where that fails: the first attempt is not repeated.
  Connection(ServerAddress server, Guest guest, Notice notice, const Patience& patience = {});

  /// What the server said to the last hello.
  const lobby::Welcome& welcome() const { return welcome_; }

  /// The answer to a request, however often the connection is lost meanwhile; news that comes first
  /// waits for `next`. A request is answered by what lobby.hpp names for it or by Refused, all else
  /// is a CommandError, and so is a server that stays away. The answer to Create, Join or Watch
  /// makes the match the followed one, and the entry that answers Act or Claim comes as news too,
  /// each entry once.
  lobby::Answer ask(const lobby::Request& request);

  /// A record as it stands, entries from its first on.
  std::variant<record::Record, lobby::Refused> fetch(lobby::Fetch request);

  /// The next news of the followed match; nothing after `patience`, or once `other` (a file
  /// descriptor, or -1) can be read.
  std::optional<News> next(Milliseconds patience, int other = -1);

  /// Takes in what has come meanwhile and shows the server that we are there, without waiting and
  /// without coming back where the connection is lost: for whoever is busy for long.
  void serve();

 private:
  using Clock = std::chrono::steady_clock;
  using Piece = std::function<void(const lobby::Answer&)>;

  struct Following {
    match::MatchId match{};
    std::optional<lobby::InviteCode> code;
    bool seated = false;
    match::Seq next{};  ///< the first entry that has not been told
  };

  // One connection. Each throws Lost when it breaks, and CommandError when coming back is no use.
  void open();
  void hello();
  void resume();
  void send(lobby::RequestId id, const lobby::Request& request);
  lobby::Answer ask_once(const lobby::Request& request, const Piece& piece = {});
  std::optional<lobby::Told> take();
  Woke fill(Milliseconds patience, int other);
  void stay_in_touch();

  /// Makes a lost connection again, patiently.
  void reopen(const std::string& why);

  void note(const lobby::Request& request, const lobby::Answer& answer);
  void hear(const lobby::Answer& answer);
  void hear(const lobby::EntryNews& news);

  ServerAddress server_;
  Guest guest_;
  Notice notice_;
  Patience patience_;

  std::optional<Stream> stream_;
  std::string lost_;  ///< why the connection was lost while nobody waited for it; else empty
  wire::FrameDecoder frames_{wire::max_answer_frame};
  std::vector<std::uint8_t> received_;  ///< not yet cut into frames
  Clock::time_point heard_;             ///< when something was last received
  Clock::time_point spoke_;             ///< when something was last sent

  std::uint32_t last_id_ = 0;
  lobby::Welcome welcome_;
  std::optional<lobby::Token> token_;
  std::optional<Following> following_;
  std::deque<News> news_;
};

}  // namespace breakshot::client

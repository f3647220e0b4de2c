// A client of a server in the tests: a plain socket, whose reads wait.
#pragma once

#include <arpa/inet.h>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <netinet/in.h>
#include <string>
#include <string_view>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>
#include <utility>

#include <gtest/gtest.h>

namespace prehend::test {

// Connected to a port of 127.0.0.1. What takes longer than a minute has failed.
class SocketClient {
 public:
  explicit SocketClient(std::uint16_t port) : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
    const timeval patience{60, 0};
    ::setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
    ::setsockopt(socket_, SOL_SOCKET, SO_SNDTIMEO, &patience, sizeof patience);
    sockaddr_in place{};
    place.sin_family = AF_INET;
    place.sin_port = htons(port);
    place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    is_connected_ = ::connect(socket_, reinterpret_cast<sockaddr*>(&place), sizeof place) == 0;
  }
  ~SocketClient() { close(); }
  SocketClient(const SocketClient&) = delete;
  SocketClient& operator=(const SocketClient&) = delete;
  SocketClient(SocketClient&& other) noexcept
      : socket_(std::exchange(other.socket_, -1)),
        is_connected_(other.is_connected_),
        unread_(std::move(other.unread_)) {}
  SocketClient& operator=(SocketClient&&) = delete;

  bool is_connected() const { return is_connected_; }

  // Whether all was taken.
  bool send(std::string_view bytes) {
    while (!bytes.empty()) {
      const ssize_t sent = ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
      if (sent <= 0) return false;
      bytes.remove_prefix(static_cast<std::size_t>(sent));
    }
    return true;
  }

  // The next line without its end; "(closed)" where the connection ends before.
  std::string line() {
    std::size_t end = unread_.find('\n');
    while (end == std::string::npos) {
      const std::size_t looked = unread_.size();
      if (!read_more()) return "(closed)";
      end = unread_.find('\n', looked);
    }
    std::string text = unread_.substr(0, end);
    unread_.erase(0, end + 1);
    return text;
  }

  // So many bytes, or those until the connection ends.
  std::string bytes(std::size_t count) {
    while (unread_.size() < count && read_more()) {
    }
    std::string text = unread_.substr(0, count);
    unread_.erase(0, count);
    return text;
  }

  // All until the connection ends.
  std::string rest() {
    while (read_more()) {
    }
    return std::exchange(unread_, {});
  }

  // What this client still has to say is over; it goes on to read.
  void end_sending() { ::shutdown(socket_, SHUT_WR); }

  // Asks the system to hold little of what was not read.
  void read_little() {
    const int size = 4096;
    ::setsockopt(socket_, SOL_SOCKET, SO_RCVBUF, &size, sizeof size);
  }

  void close() {
    if (socket_ >= 0) ::close(std::exchange(socket_, -1));
  }

 private:
  bool read_more() {
    char piece[65536];
    const ssize_t got = ::recv(socket_, piece, sizeof piece, 0);
    if (got < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) ADD_FAILURE() << "nothing came";
    if (got <= 0) return false;
    unread_.append(piece, static_cast<std::size_t>(got));
    return true;
  }

  int socket_;
  bool is_connected_ = false;
  std::string unread_;
};

}  // namespace prehend::test

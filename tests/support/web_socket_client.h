// A WebSocket's other end, frame by frame (RFC 6455), for tests.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "tests/support/socket_client.h"

namespace prehend::test {

struct Frame {
  int kind = -1;  // kText and so on; -1: the connection ended
  bool is_last = true;
  std::string payload;
};

class WebSocketClient {
 public:
  static constexpr int kMore = 0;
  static constexpr int kText = 1;
  static constexpr int kBinary = 2;
  static constexpr int kClose = 8;
  static constexpr int kPing = 9;
  static constexpr int kPong = 10;

  WebSocketClient(std::uint16_t port, const std::string& token)
      : WebSocketClient(port, token, "127.0.0.1:" + std::to_string(port), "") {}

  // `origin`: with the end of its line, or empty.
  WebSocketClient(std::uint16_t port, const std::string& token, const std::string& host,
                  const std::string& origin)
      : socket_(port) {
    socket_.send("GET /socket?token=" + token + " HTTP/1.1\r\nHost: " + host + "\r\n" + origin +
                 "Upgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
                 "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n\r\n");
    status_ = socket_.line();
    for (std::string line = status_; line != "\r" && line != "(closed)"; line = socket_.line()) {
      header_ += line + "\n";
    }
  }

  // The first line of the server's answer, and all lines.
  const std::string& status() const { return status_; }
  const std::string& header() const { return header_; }

  bool send_frame(int kind, std::string_view payload, bool is_last = true) {
    return socket_.send(frame(kind, payload, is_last));
  }

  // The bytes of a frame, masked as those of clients are.
  static std::string frame(int kind, std::string_view payload, bool is_last = true) {
    std::string bytes(1, static_cast<char>(kind | (is_last ? 0x80 : 0)));
    if (payload.size() < 126) {
      bytes += static_cast<char>(0x80U | payload.size());
    } else {
      const int width = payload.size() < 65536 ? 2 : 8;
      bytes += static_cast<char>(0x80 | (width == 2 ? 126 : 127));
      for (int i = width - 1; i >= 0; --i) {
        bytes += static_cast<char>((std::uint64_t{payload.size()} >> (8 * i)) & 255U);
      }
    }
    const std::string_view mask = "\x37\xFA\x21\x3D";
    bytes += mask;
    for (std::size_t i = 0; i < payload.size(); ++i) {
      bytes += static_cast<char>(payload[i] ^ mask[i % 4]);
    }
    return bytes;
  }

  Frame next_frame() {
    const std::string head = socket_.bytes(2);
    if (head.size() < 2) return {};
    Frame result;
    result.kind = head[0] & 15;
    result.is_last = (head[0] & 0x80) != 0;
    std::uint64_t size = static_cast<std::uint64_t>(head[1] & 127);
    if (size >= 126) {
      const std::string more = socket_.bytes(size == 126 ? 2 : 8);
      size = 0;
      for (const char byte : more) size = size * 256 + static_cast<unsigned char>(byte);
    }
    result.payload = socket_.bytes(size);
    return result;
  }

  SocketClient& socket() { return socket_; }

 private:
  SocketClient socket_;
  std::string status_;
  std::string header_;
};

}  // namespace prehend::test

#include "app/packed_text.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace halfdisk {
namespace {

constexpr std::string_view kAlphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";

/// Base64 with the alphabet of RFC 4648, section 5, without padding.
std::string encoded(const std::vector<unsigned char>& bytes) {
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t group = 0;
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
        for (std::size_t k = 0; k < 3; ++k) group = group << 8 | (k < count ? bytes[i + k] : 0u);
        for (std::size_t k = 0; k <= count; ++k) text += kAlphabet[group >> (18 - 6 * k) & 63u];
    }
    return text;
}

std::optional<std::vector<unsigned char>> decoded(std::string_view text) {
    std::vector<unsigned char> bytes;
    std::uint32_t group = 0;
    int bits = 0;
    for (const char c : text) {
        if (c == ' ' || c == '\n' || c == '\r' || c == '\t') continue;
        const std::size_t value = kAlphabet.find(c);
        if (value == std::string_view::npos) return std::nullopt;
        group = group << 6 | static_cast<std::uint32_t>(value);
        bits += 6;
        if (bits < 8) continue;
        bits -= 8;
        bytes.push_back(static_cast<unsigned char>(group >> bits & 0xFFu));
    }
    return bytes;
}

std::vector<unsigned char> packed(const std::string& text) {
    uLongf size = compressBound(text.size());
    std::vector<unsigned char> bytes(size);
    compress2(bytes.data(), &size, reinterpret_cast<const Bytef*>(text.data()), text.size(),
              Z_BEST_COMPRESSION);
    bytes.resize(size);
    return bytes;
}

}  // namespace

std::string packedText(const std::string& text) {
    return encoded(packed(text));
}

std::optional<std::string> unpackedText(std::string_view text, std::size_t most) {
    const auto bytes = decoded(text);
    if (!bytes) return std::nullopt;
    std::string unpacked;
    z_stream stream{};
    if (inflateInit(&stream) != Z_OK) return std::nullopt;
    stream.next_in = const_cast<Bytef*>(bytes->data());
    stream.avail_in = static_cast<uInt>(bytes->size());
    std::array<char, 65536> chunk;
    int result = Z_OK;
    while (result == Z_OK && unpacked.size() <= most) {
        stream.next_out = reinterpret_cast<Bytef*>(chunk.data());
        stream.avail_out = static_cast<uInt>(chunk.size());
        result = inflate(&stream, Z_NO_FLUSH);
        unpacked.append(chunk.data(), chunk.size() - stream.avail_out);
    }
    inflateEnd(&stream);
    if (result != Z_STREAM_END || unpacked.size() > most) return std::nullopt;
    return unpacked;
}

}  // namespace halfdisk

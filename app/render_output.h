// To which files can a rendering be written, and how? One row per format.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace halfdisk {

struct RenderResult;

struct OutputFormat {
    std::string_view extension;
    std::string_view meaning;
    std::string (*encode)(const RenderResult& result);
};

std::string pngOf(const RenderResult& result);
std::string pfmOf(const RenderResult& result);
std::string csvOf(const RenderResult& result);
std::string jsonOfResult(const RenderResult& result);

inline constexpr std::array<OutputFormat, 4> kOutputFormats{{
    {".png", "a picture, exposed (--exposure) and in sRGB", pngOf},
    {".pfm", "the same picture's linear values, 32-bit floats", pfmOf},
    {".csv", "mean and standard error of every pixel, its place, and all facts as comments", csvOf},
    {".json", "the same, without the places", jsonOfResult},
}};

/// Throws InputError for an extension that is unknown, a file named twice, and a folder in which no file can
/// be made.
void refuseOutputs(const std::vector<std::filesystem::path>& outputs);

/// Throws InputError if the path is a folder, or if no file can be made beside it. Making one is the only
/// sure test: permissions do not tell of read-only disks.
void refuseUnwritable(const std::filesystem::path& path);

/// Each written whole or not at all. Throws std::runtime_error naming the file.
void writeOutputs(const std::vector<std::filesystem::path>& outputs, const RenderResult& result);

}  // namespace halfdisk

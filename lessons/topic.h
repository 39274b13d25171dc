// Which part of the picture does a term of a lesson speak of? While a reader looks a term up, its ray, its
// line of code and its mark in a plot light up.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

namespace halfdisk {

enum class Topic : std::uint8_t {
    none,
    shadowRay,
    halfDisk,
    normal,
    tangent,
    sample,
    radiance,
    irradiance,
    albedo,
    recursion,
    error,
    light,
    eye
};

struct TopicRow {
    Topic topic;
    std::string_view terms;      ///< separated by '|', lower case
    std::array<int, 3> listing;  ///< lines of the published listing; 0: none
};

inline constexpr std::array<TopicRow, 12> kTopics{{
    {Topic::shadowRay, "shadow ray|direct light|occluder", {7, 8, 10}},
    {Topic::halfDisk, "half-disk|integral", {15, 17, 0}},
    {Topic::normal, "normal|frame", {3, 13, 21}},
    {Topic::tangent, "tangent", {18, 19, 0}},
    {Topic::sample, "sample|pdf|uniform|stratified|cosine samples|importance sampling|weight", {17, 27, 0}},
    {Topic::radiance, "radiance", {24, 0, 0}},
    {Topic::irradiance, "irradiance", {27, 30, 0}},
    {Topic::albedo, "albedo|diffuse|glossy|lobe|scattering", {33, 0, 0}},
    {Topic::recursion, "recursion|depth|indirect light|path|path tracing", {2, 24, 0}},
    {Topic::error,
     "variance|standard error|noise|spread|confidence|bias|biased|unbiased|monte carlo",
     {15, 30, 0}},
    {Topic::light, "virtual light|environment|light path|photon|forward tracing", {6, 0, 0}},
    {Topic::eye, "pupil|sensor|strip|backward tracing", {0, 0, 0}},
}};

/// By the term's English name, ASCII case ignored.
Topic topicOf(std::string_view term);

/// The row of a topic; null for none.
const TopicRow* rowOf(Topic topic);

}  // namespace halfdisk

// Is the text of an argument understood, and refused with one clear message?
#include <doctest/doctest.h>

#include <string>

#include "app/cli_arguments.h"
#include "app/cli_probe.h"

using namespace halfdisk;

namespace {

template <class Function>
std::string messageOf(const Function& function) {
    try {
        function();
    } catch (const InputError& error) {
        return error.what();
    }
    return "nothing was thrown";
}

}  // namespace

TEST_CASE("numbers: finite decimals and nothing else") {
    CHECK(parseNumber("1") == 1.0);
    CHECK(parseNumber("-0.5") == -0.5);
    CHECK(parseNumber("+2.") == 2.0);
    CHECK(parseNumber(".25") == 0.25);
    CHECK(parseNumber("1e3") == 1000.0);
    CHECK(parseNumber("-1E-3") == -0.001);
    for (const char* text : {"", " 1", "1 ", "nan", "inf", "-inf", "1e999", "-1e999", "0x10", "1,0", "1e",
                             "e1", "--1", "1.2.3", "1_000", "\xff"})
        CHECK_MESSAGE(!parseNumber(text), text);
}

TEST_CASE("whole numbers: digits up to 2^64 - 1, exponents where they are exact") {
    CHECK(parseWhole("0") == 0u);
    CHECK(parseWhole("007") == 7u);
    CHECK(parseWhole("18446744073709551615") == UINT64_MAX);
    CHECK(parseWhole("1e3") == 1000u);
    CHECK(parseWhole("1.5e3") == 1500u);
    CHECK(parseWhole("1E9") == 1'000'000'000u);
    for (const char* text : {"18446744073709551616", "99999999999999999999", "-1", "-0", "+1", "1.0", "1.5",
                             "1e-1", "1e17", "1e400", "", "x", "1 "})
        CHECK_MESSAGE(!parseWhole(text), text);
}

TEST_CASE("whole arguments keep to their range and name it") {
    CHECK(wholeArgument("--samples", "1000000000", kSamplesInfo) == 1'000'000'000u);
    CHECK(wholeArgument("--threads", "256", kThreadsInfo) == 256u);
    CHECK(messageOf([] { wholeArgument("--threads", "257", kThreadsInfo); }) ==
          "--threads: '257' is not a whole number from 1 to 256");
    CHECK(messageOf([] { wholeArgument("--samples", "0", kSamplesInfo); }) ==
          "--samples: '0' is not a whole number from 1 to 1000000000");
}

TEST_CASE("points and directions") {
    CHECK(pointArgument("--at", "-1.5,2e1") == Vec2(-1.5, 20.0));
    CHECK(pointArgument("--at", "1e9,-1e9") == Vec2(1e9, -1e9));
    CHECK(messageOf([] { pointArgument("--at", "foo", "X,Y or NAME:T"); }) ==
          "--at: 'foo' is not a point, expected X,Y or NAME:T");
    for (const char* text : {"", ",", "1", "1,", ",1", "1,2,3", "1;2", "nan,1", "1,inf", "1, 2", "1e10,0"})
        CHECK_THROWS_AS(pointArgument("--at", text), InputError);

    CHECK(directionArgument("--normal", "0,-7") == Vec2(0.0, -1.0));
    CHECK(directionArgument("--normal", "3,4").x == doctest::Approx(0.6).epsilon(1e-15));
    CHECK(glm::length(directionArgument("--normal", "1e300,1e300")) == doctest::Approx(1.0).epsilon(1e-15));
    CHECK(glm::length(directionArgument("--normal", "-1e-310,2e-310")) ==
          doctest::Approx(1.0).epsilon(1e-15));
    for (const char* text : {"0,0", "-0,0", "0", "nan,0", "inf,0", "up"})
        CHECK_THROWS_AS(directionArgument("--normal", text), InputError);
}

TEST_CASE("picture sizes") {
    CHECK(sizeArgument("--size", "1280x800") == PictureSize{1280, 800});
    CHECK(sizeArgument("--size", "320x7680") == PictureSize{320, 7680});
    for (const char* text : {"", "x", "319x800", "800x7681", "1280", "1280x", "1280x800x2", "1280X800",
                             "-1280x800", "1e3x800", "4294968576x800"})
        CHECK_THROWS_AS(sizeArgument("--size", text), InputError);
}

TEST_CASE("names of closed sets, with the nearest one suggested") {
    CHECK(namedArgument("--sampler", "cosine", kSamplers) == Sampler::cosine);
    const std::string message = messageOf([] { namedArgument("--sampler", "cosin", kSamplers); });
    CHECK(message ==
          "--sampler: 'cosin' is unknown, expected one of \"uniform\", \"cosine\", \"stratified\" or "
          "\"lobe\"; did you mean \"cosine\"?");
}

TEST_CASE("every defect is understood by its name, alone and in a list") {
    for (const auto& defect : kDefects) {
        const DefectSet set = defectsArgument("--as-printed", defect.name);
        CHECK(set.has(defect.value));
        for (const auto& other : kDefects) CHECK((other.value == defect.value) == set.has(other.value));
    }
    const DefectSet two = defectsArgument("--as-printed", "pdf,frame");
    CHECK(two.has(Defect::frame));
    CHECK(two.has(Defect::pdf));
    CHECK(defectsArgument("--as-printed", joinedNames(kDefects, ",")) == DefectSet::all());
    for (const char* text : {"", ",", "frame,", ",frame", "frame,,pdf", "bogus", "frame pdf"})
        CHECK_THROWS_AS(defectsArgument("--as-printed", text), InputError);
}

TEST_CASE("a message quotes strange text safely") {
    const std::string message = messageOf([] { pointArgument("--at", "a\nb\x1b[31m"); });
    CHECK(message == "--at: 'a?b?[31m' is not a point, expected X,Y");
}

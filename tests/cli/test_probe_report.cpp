// Is an answer told without hiding what went wrong, and as valid JSON whatever the numbers are?
#include <doctest/doctest.h>

#include <limits>
#include <string>

#include "app/cli_probe_report.h"

using namespace halfdisk;

namespace {

bool reportHolds(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

ProbeAnswer plainAnswer() {
    ProbeAnswer answer;
    answer.place.shaded.N = {-0.0, 1.0};
    answer.estimate.samples.count = 100;
    answer.irradiance.mean = Rgb(2.0);
    answer.irradiance.standardError = Rgb(0.5);
    return answer;
}

}  // namespace

TEST_CASE("bad samples are told loudly, good ones quietly") {
    ProbeAnswer answer = plainAnswer();
    CHECK_FALSE(reportHolds(probeTable(answer), "WARNING"));
    answer.estimate.samples.nonFinite = 3;
    CHECK(reportHolds(probeTable(answer), "WARNING: 3 of 103 samples were NaN or infinite"));
    CHECK(probeJson(answer)["nonFinite"] == 3);
}

TEST_CASE("negative light is a warning unless the printed defects make it") {
    ProbeAnswer answer = plainAnswer();
    answer.estimate.samples.negative = 5;
    CHECK(reportHolds(probeTable(answer), "WARNING: 5 samples were negative"));
    answer.question.settings.defects.set(Defect::cosine, true);
    CHECK_FALSE(reportHolds(probeTable(answer), "WARNING"));
}

TEST_CASE("the exact answer is told with its distance in standard errors") {
    ProbeAnswer answer = plainAnswer();
    CHECK_FALSE(reportHolds(probeTable(answer), "exact"));
    answer.exact = Rgb(3.0);
    CHECK(reportHolds(probeTable(answer), "exact E"));
    CHECK(reportHolds(probeTable(answer), "-2"));
    CHECK_FALSE(probeJson(answer).contains("exact"));
}

TEST_CASE("values that are not finite become null, negative zeros lose their sign") {
    ProbeAnswer answer = plainAnswer();
    answer.irradiance.mean = {std::numeric_limits<double>::quiet_NaN(), kInfinity, -0.0};
    const std::string text = probeJson(answer).dump();
    CHECK(reportHolds(text, R"("mean":[null,null,0.0])"));
    CHECK(reportHolds(text, R"("normal":[0.0,1.0])"));
    CHECK(Json::accept(text));
}

TEST_CASE("emitters come last, the printed defects only when one is on, in the order of their table") {
    ProbeAnswer answer = plainAnswer();
    CHECK(probeJson(answer)["emitters"] == "sample");
    CHECK_FALSE(probeJson(answer).contains("asPrinted"));
    answer.question.settings.defects.set(Defect::offset, true);
    answer.question.settings.defects.set(Defect::frame, true);
    CHECK(probeJson(answer)["asPrinted"].dump() == R"(["frame","offset"])");
}

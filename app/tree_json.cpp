#include "app/tree_json.h"

#include "app/cli_output.h"

namespace halfdisk {
namespace {

std::string dumped(const Json& json) {
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Json segmentJson(std::uint32_t segment) {
    return segment == kNoSegment ? Json(nullptr) : Json(segment);
}

Json settingsJson(const Settings& settings) {
    Json defects = Json::array();
    for (const Named<Defect>& defect : kDefects)
        if (settings.defects.has(defect.value)) defects.push_back(defect.name);
    return {{"samples", settings.samples},
            {"depth", settings.maxDepth},
            {"seed", settings.seed},
            {"sampler", nameOf(kSamplers, settings.sampler)},
            {"emitters", nameOf(kEmitters, settings.emitters)},
            {"defects", defects},
            {"maxSpecular", settings.maxSpecular}};
}

/// What another estimator's run says in place of castRay's.
void tellPathRun(Json& head, const PathRun& run) {
    head["truncated"] = run.record.truncated;
    head["rays"] = run.counts.rays;
    head["refused"] = !run.refusal.empty();
    head["divisor"] = run.divisor;
    head["estimate"] = run.refusal.empty() ? Json{{"total", jsonOf(run.estimate)}} : Json(nullptr);
    head["standardError"] = run.standardError ? jsonOf(*run.standardError) : Json(nullptr);
}

Json headOf(const AppState& state) {
    Json head{{"format", "halfdisk recorded run"}, {"lesson", nullptr}, {"step", nullptr}};
    if (state.lesson) {
        head["lesson"] = state.lesson->slug;
        head["step"] = state.step + 1;
    }
    const LightAnswer* answer = state.answer.get();
    const PreparedScene& prepared = answer ? *answer->asked.scene : *state.scene;
    const WallPoint at = answer ? answer->asked.at : state.at;
    head["settings"] = settingsJson(answer ? answer->asked.settings : state.settings);
    head["point"] = {{"wall", prepared.scene.segmentNames[at.segment]},
                     {"segment", at.segment},
                     {"t", jsonOf(at.t)},
                     {"P", jsonOf(positionOf(prepared.scene, at))},
                     {"N", jsonOf(prepared.index.normal(at.segment))}};
    head["truncated"] = answer && answer->record && answer->record->truncated;
    head["rays"] = answer ? answer->rays : 0;
    head["refused"] = answer && answer->tooManyRays;
    head["estimate"] = nullptr;
    head["standardError"] = nullptr;
    head["exact"] = nullptr;
    if (answer && answer->record)
        head["estimate"] = {{"direct", jsonOf(answer->estimate.direct)},
                            {"indirect", jsonOf(answer->estimate.indirect)},
                            {"total", jsonOf(answer->estimate.total())}};
    if (answer && answer->standardError) head["standardError"] = jsonOf(*answer->standardError);
    if (answer && answer->exact) head["exact"] = jsonOf(*answer->exact);
    head["run"] = nameOf(kRuns, answer ? answer->asked.run : state.run);
    if (answer && answer->pathRun) tellPathRun(head, *answer->pathRun);
    const auto pixel = answer ? pixelOf(*answer) : std::nullopt;
    if (pixel) head["exact"] = nullptr;  // that is E at P
    head["pixel"] = pixel ? Json(*pixel) : Json(nullptr);
    const bool oneOfTwo = pixel && answer->asked.makers.second;
    head["pixelOf"] = oneOfTwo ? Json(nameOf(kSides, answer->asked.pixelOf)) : Json(nullptr);
    head["unit"] = answer ? unitOf(*answer) : "W/m";
    head["shownEvents"] = state.playback.stepping ? Json(state.playback.event) : Json(nullptr);
    head["walls"] = prepared.scene.segmentNames;
    return head;
}

Json callJson(std::size_t index, const Call& call) {
    return {{"call", index},
            {"parent", call.parent == kNoCall ? Json(nullptr) : Json(call.parent)},
            {"sample", call.sample},
            {"depth", call.depth},
            {"segment", segmentJson(call.at.segment)},
            {"P", jsonOf(call.at.P)},
            {"N", jsonOf(call.at.N)},
            {"firstEvent", call.firstEvent},
            {"lastEvent", call.lastEvent}};
}

Json eventJson(std::size_t index, const Event& event) {
    return {{"event", index},
            {"kind", nameOf(kEventKinds, event.kind)},
            {"line", listingLine(event.kind)},
            {"depth", event.depth},
            {"call", event.call},
            {"n", event.n},
            {"light", event.light},
            {"segment", segmentJson(event.segment)},
            {"theta", jsonOf(event.theta)},
            {"pdfAngle", jsonOf(event.pdfAngle)},
            {"visible", event.visible},
            {"onward", event.onward},
            {"missed", event.missed},
            {"from", jsonOf(event.from)},
            {"to", jsonOf(event.to)},
            {"direction", jsonOf(event.direction)},
            {"value", jsonOf(event.value)},
            {"sum", jsonOf(event.sum)}};
}

Json pathEventJson(std::size_t index, const PathEvent& event) {
    // The build's own folder is nobody's business.
    const std::size_t root = event.where.file.rfind("core/");
    const std::string_view file =
        root == std::string_view::npos ? event.where.file : event.where.file.substr(root);
    return {{"event", index},
            {"kind", nameOf(kPathEventKinds, event.kind)},
            {"file", file},
            {"line", event.where.line},
            {"path", event.path},
            {"vertex", event.vertex},
            {"carried", event.carried == Carried::radiance ? "radiance" : "power"},
            {"segment", segmentJson(event.segment)},
            {"s", event.s},
            {"t", event.t},
            {"photons", event.photons},
            {"radius", jsonOf(event.radius)},
            {"visible", event.visible},
            {"missed", event.missed},
            {"delta", event.delta},
            {"from", jsonOf(event.from)},
            {"to", jsonOf(event.to)},
            {"pdfAngle", jsonOf(event.pdfAngle)},
            {"weight", jsonOf(event.weight)},
            {"throughput", jsonOf(event.throughput)},
            {"value", jsonOf(event.value)},
            {"sum", jsonOf(event.sum)}};
}

/// A list with one entry a line: as one object it would take ten times the memory.
template <class Entry, class Function>
void appendList(std::string& text, std::string_view key, const std::vector<Entry>& entries,
                const Function& jsonOfEntry) {
    text += ",\n\"";
    text += key;
    text += "\":[";
    for (std::size_t i = 0; i < entries.size(); ++i) {
        text += i > 0 ? ",\n" : "\n";
        text += dumped(jsonOfEntry(i, entries[i]));
    }
    text += ']';
}

}  // namespace

std::string treeJson(const AppState& state) {
    std::string text;
    const Json head = headOf(state);
    for (const auto& fact : head.items()) {
        text += text.empty() ? "{\n" : ",\n";
        text += dumped(fact.key());
        text += ':';
        text += dumped(fact.value());
    }
    const Record none;
    const Record& record = state.answer && state.answer->record ? *state.answer->record : none;
    const bool ofPaths = state.answer && state.answer->pathRun;
    appendList(text, "calls", ofPaths ? none.calls : record.calls, callJson);
    if (ofPaths)
        appendList(text, "events", state.answer->pathRun->record.events, pathEventJson);
    else
        appendList(text, "events", record.events, eventJson);
    text += "\n}\n";
    return text;
}

}  // namespace halfdisk

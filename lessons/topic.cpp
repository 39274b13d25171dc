#include "lessons/topic.h"

#include <string>

namespace halfdisk {

Topic topicOf(std::string_view term) {
    std::string lower(term);
    for (char& c : lower)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    for (const TopicRow& row : kTopics)
        for (std::string_view rest = row.terms; !rest.empty();) {
            const std::size_t end = rest.find('|');
            if (rest.substr(0, end) == lower) return row.topic;
            rest = end == std::string_view::npos ? std::string_view() : rest.substr(end + 1);
        }
    return Topic::none;
}

const TopicRow* rowOf(Topic topic) {
    for (const TopicRow& row : kTopics)
        if (row.topic == topic) return &row;
    return nullptr;
}

}  // namespace halfdisk

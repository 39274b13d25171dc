// Does the environment get its strip from a list or a picture, in linear light, and only from a sound one?
#include "lessons/sky_image.h"

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <png.h>

#include <cmath>
#include <functional>
#include <random>
#include <string>

#include "error_cases.h"
#include "lessons/scene_file.h"
#include "temp_folder.h"

using namespace halfdisk;

namespace {

struct Bitmap {
    std::uint32_t columns, rows;
    int bits;      ///< per channel, 8 or 16
    int channels;  ///< 1, 3 or 4
    std::function<int(std::uint32_t x, std::uint32_t y, int channel)> level;
    double gamma = 0.0;  ///< that the file names; 0: none
    bool saysSrgb = false;
};

/// A PNG that says about its gamma what is asked for; libpng's simplified interface would always add one.
std::string pngOf(const Bitmap& bitmap) {
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    std::string bytes;
    png_set_write_fn(
        png, &bytes,
        [](png_structp self, png_bytep data, std::size_t size) {
            static_cast<std::string*>(png_get_io_ptr(self))->append(reinterpret_cast<char*>(data), size);
        },
        nullptr);
    const int type = bitmap.channels == 1   ? PNG_COLOR_TYPE_GRAY
                     : bitmap.channels == 3 ? PNG_COLOR_TYPE_RGB
                                            : PNG_COLOR_TYPE_RGB_ALPHA;
    png_set_IHDR(png, info, bitmap.columns, bitmap.rows, bitmap.bits, type, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    if (bitmap.gamma > 0.0) png_set_gAMA(png, info, bitmap.gamma);
    if (bitmap.saysSrgb) png_set_sRGB_gAMA_and_cHRM(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
    png_write_info(png, info);
    for (std::uint32_t y = 0; y < bitmap.rows; ++y) {
        std::string row;
        for (std::uint32_t x = 0; x < bitmap.columns; ++x)
            for (int c = 0; c < bitmap.channels; ++c) {
                const int level = bitmap.level(x, y, c);
                if (bitmap.bits == 16) row += static_cast<char>(level >> 8);
                row += static_cast<char>(level & 255);
            }
        png_write_row(png, reinterpret_cast<png_const_bytep>(row.data()));
    }
    png_write_end(png, nullptr);
    png_destroy_write_struct(&png, &info);
    return bytes;
}

/// IEC 61966-2-1, written down anew.
double decoded(double v) {
    return v <= 0.04045 ? v / 12.92 : std::exp(2.4 * std::log((v + 0.055) / 1.055));
}

void replaceAt(std::string& bytes, std::size_t at, std::string_view with) {
    bytes.replace(at, with.size(), with);
}

std::string refusal(const std::string& png) {
    try {
        decodeSky(png, "sky.png");
    } catch (const InputError& error) {
        CHECK(error.file == "sky.png");
        return error.text;
    }
    return "accepted";
}

const std::string kSmall = pngOf({2, 1, 8, 3, [](auto x, auto, int) { return x == 0 ? 255 : 0; }});

void check(const std::string& text, std::initializer_list<std::string_view> said) {
    checkErrors({{text, said}}, "room.toml",
                [](const std::string& scene) { parseScene(scene, "room.toml"); });
}

}  // namespace

TEST_CASE("each of the 256 levels is decoded by the formula of sRGB") {
    const auto sky = decodeSky(pngOf({256, 1, 8, 3,
                                      [](auto x, auto, int channel) {
                                          const int level = static_cast<int>(x);
                                          return channel == 0 ? level : channel == 1 ? 255 - level : 0;
                                      }}),
                               "x");
    REQUIRE(sky.size() == 256);
    for (int level = 0; level < 256; ++level) {
        const Rgb& entry = sky[static_cast<std::size_t>(level)];
        CHECK(entry.x == doctest::Approx(decoded(level / 255.0)).epsilon(1e-12));
        CHECK(entry.y == doctest::Approx(decoded((255 - level) / 255.0)).epsilon(1e-12));
        CHECK(entry.z == 0.0);
    }
    CHECK(sky[0].x == 0.0);
    CHECK(sky[255].x == 1.0);
}

TEST_CASE("16 bits are decoded by the same formula") {
    const auto sky = decodeSky(
        pngOf({65536, 1, 16, 3, [](auto x, auto, int c) { return c == 0 ? static_cast<int>(x) : 0; }}), "x");
    REQUIRE(sky.size() == 65536);
    double worst = 0.0;
    for (std::size_t level = 0; level < 65536; ++level)
        worst = std::max(worst, std::abs(sky[level].x - decoded(static_cast<double>(level) / 65535.0)));
    CHECK(worst < 1e-15);
    CHECK(sky[65535] == Rgb(1, 0, 0));
}

TEST_CASE("16 bits follow what the file says about its gamma") {
    const auto ramp = [](double gamma, bool saysSrgb) {
        const auto sky =
            decodeSky(pngOf({256, 1, 16, 1, [](auto x, auto, int) { return static_cast<int>(x) * 257; },
                             gamma, saysSrgb}),
                      "x");
        double worst[2] = {0.0, 0.0};  // beside sRGB, beside light as it stands
        for (std::size_t x = 0; x < 256; ++x) {
            const double level = static_cast<double>(x) / 255.0;
            worst[0] = std::max(worst[0], std::abs(sky.at(x).y - decoded(level)));
            worst[1] = std::max(worst[1], std::abs(sky.at(x).y - level));
        }
        return std::pair(worst[0], worst[1]);
    };
    CHECK(ramp(0.0, true).first < 1e-15);
    CHECK(ramp(0.45455, false).first < 1e-15);
    CHECK(ramp(1.0, false).second < 1e-15);
}

TEST_CASE("16 bits with opacity are decoded first and dimmed then") {
    const auto sky = decodeSky(
        pngOf({3, 1, 16, 4, [](auto x, auto, int c) { return c < 3 ? 30000 : static_cast<int>(x) * 32767; }}),
        "x");
    const double light = decoded(30000 / 65535.0);
    CHECK(sky.at(0) == Rgb(0.0));
    CHECK(sky.at(1).x == doctest::Approx(light * 32767 / 65535).epsilon(1e-4));  // levels are rounded
    CHECK(sky.at(2).x == doctest::Approx(light * 65534 / 65535).epsilon(1e-4));
}

TEST_CASE("a column is the mean of its light, not of its levels") {
    const auto sky = decodeSky(pngOf({3, 4, 8, 1, [](auto x, auto y, int) { return y < x ? 255 : 0; }}), "x");
    REQUIRE(sky.size() == 3);
    for (std::size_t k = 0; k < 3; ++k) CHECK(sky[k] == Rgb(0.25 * static_cast<double>(k)));
    const auto grey =
        decodeSky(pngOf({1, 2, 8, 1, [](auto, auto y, int) { return y == 0 ? 100 : 200; }}), "x");
    CHECK(grey.at(0).x == doctest::Approx((decoded(100 / 255.0) + decoded(200 / 255.0)) / 2).epsilon(1e-12));
}

TEST_CASE("what is transparent is black") {
    const auto sky = decodeSky(
        pngOf({2, 1, 8, 4, [](auto x, auto, int c) { return c < 3    ? 255
                                                            : x == 0 ? 255
                                                                     : 0; }}), "x");
    CHECK(sky == std::vector<Rgb>{Rgb(1.0), Rgb(0.0)});
}

TEST_CASE("pictures that are broken or too large are refused, the latter unread") {
    CHECK(refusal("").find("no PNG") != std::string::npos);
    CHECK(refusal("title = 'x'").find("no PNG") != std::string::npos);
    CHECK(refusal(kSmall) == "accepted");
    for (std::size_t size = 1; size + 12 < kSmall.size(); ++size)  // 12: the mark of the end
        CHECK(refusal(kSmall.substr(0, size)).find("PNG") != std::string::npos);
    std::string flipped = kSmall;
    flipped[flipped.find("IDAT") + 6] ^= 0x55;
    CHECK(refusal(flipped).find("broken") != std::string::npos);
    const std::string deep = pngOf({2, 1, 16, 3, [](auto, auto, int) { return 9; }, 0.0, true});
    for (std::size_t size = 1; size + 12 < deep.size(); ++size)
        CHECK(refusal(deep.substr(0, size)).find("PNG") != std::string::npos);

    // Sizes in the header; its checksum is written anew.
    const auto withSize = [](std::uint32_t columns, std::uint32_t rows) {
        const auto bigEndian = [](std::uint32_t v) {
            return std::string{static_cast<char>(v >> 24), static_cast<char>(v >> 16 & 255),
                               static_cast<char>(v >> 8 & 255), static_cast<char>(v & 255)};
        };
        std::string png = kSmall;
        replaceAt(png, 16, bigEndian(columns) + bigEndian(rows));
        std::uint32_t crc = ~0u;
        for (std::size_t i = 12; i < 29; ++i) {
            crc ^= static_cast<unsigned char>(png[i]);
            for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ (crc & 1u ? 0xEDB88320u : 0u);
        }
        replaceAt(png, 29, bigEndian(~crc));
        return png;
    };
    CHECK(refusal(withSize(2, 1)) == "accepted");
    CHECK(refusal(withSize(65537, 1)).find("65537 x 1 pixels, expected at most 65536 columns") !=
          std::string::npos);
    CHECK(refusal(withSize(2, 4097)).find("2 x 4097 pixels") != std::string::npos);
    CHECK(refusal(withSize(65536, 4096)).find("16777216 pixels in all") != std::string::npos);
    CHECK(refusal(withSize(4096, 4096)).find("broken") != std::string::npos);
    CHECK(refusal(withSize(1000000, 1000000)) != "accepted");
}

TEST_CASE("a damaged picture is refused or gives finite light") {
    std::mt19937 random(3);
    const auto below = [&](std::size_t n) { return random() % n; };
    const std::string good[] = {
        kSmall,
        pngOf({5, 3, 16, 4, [](auto x, auto y, int c) { return static_cast<int>(x * y) * c; }, 0.0, true})};
    int refused = 0;
    for (int i = 0; i < 4000; ++i) {
        std::string png = good[i % 2];
        for (std::size_t edits = 1 + below(3); edits > 0; --edits)
            png[below(png.size())] = static_cast<char>(random());
        try {
            for (const Rgb& entry : decodeSky(png, "x"))
                CHECK((isFinite(entry) && glm::min(glm::min(entry.x, entry.y), entry.z) >= 0.0));
        } catch (const InputError&) {
            ++refused;
        }
    }
    CHECK(refused > 0);
}

TEST_CASE("a list is a strip, and the radiance then is 1 unless it is told") {
    const auto light = [](const std::string& text) { return expandScene(parseScene(text, "x")).environment; };
    CHECK(light("").radiance == Rgb(0.0));
    CHECK(light("environment = {}").radiance == Rgb(0.0));
    const Environment listed = light("environment = { strip = [0, 0.5, [1, 2, 3]] }");
    CHECK(listed.radiance == Rgb(1.0));
    CHECK(listed.strip == std::vector<Rgb>{Rgb(0.0), Rgb(0.5), Rgb(1, 2, 3)});
    CHECK(light("environment = { radiance = [2, 0, 1], strip = [1] }").radiance == Rgb(2, 0, 1));
    CHECK(radianceFrom(light("environment = { radiance = 2, strip = [1, 2, 3, 4] }"), {-1, 1}) == Rgb(4.0));
    CHECK(radianceFrom(light("environment = { strip = [1, 2, 3, 4] }"), {1, -1}) == Rgb(4.0));
}

TEST_CASE("strips are checked") {
    check("environment = { strip = ^[] }", {"\"strip\" has 0 entries", "1 to 65536"});
    check("environment = { strip = ^1 }", {"\"strip\" is a whole number", "an array of colours"});
    check("environment = { strip = [1, ^-1] }", {"\"strip\" is -1"});
    check("environment = { strip = [1, ^[1, 2]] }", {"has 2 elements"});
    check("environment = { strip = [1, ^'red'] }", {"is a string"});
    check("environment = { strip = [^inf] }", {"is inf"});
    check("environment = { ^strips = [1] }", {"did you mean \"strip\"?"});
    std::string tooMany = "environment = { strip = ^[0";
    for (int i = 0; i < 65536; ++i) tooMany += ",0";
    check(tooMany + "] }", {"has 65537 entries"});
}

TEST_CASE("a picture is taken from beside the scene file, and its name is kept") {
    const TempFolder folder;
    folder.write("room/pictures/sky.png", kSmall);
    const auto file =
        folder.write("room/a.toml", "environment = { radiance = 3, image = 'pictures/sky.png' }\n");
    const SceneDescription scene = loadScene(file);
    CHECK(scene.environment.image == "pictures/sky.png");
    CHECK(expandScene(scene).environment.radiance == Rgb(3.0));
    CHECK(expandScene(scene).environment.strip == std::vector<Rgb>{Rgb(1.0), Rgb(0.0)});
    CHECK(writeScene(scene) == "environment = { image = \"pictures/sky.png\", radiance = 3.0 }\n");
    const auto copy = folder.path / "room/b.toml";
    saveScene(scene, copy);
    CHECK(loadScene(copy) == scene);
    // Elsewhere the name is kept too, although it leads nowhere.
    saveScene(scene, folder.path / "c.toml");
    CHECK(readAll(folder.path / "c.toml") == readAll(copy));
    CHECK(expandScene(loadScene(folder.write("room/d.toml", "environment.image = 'pictures/sky.png'")))
              .environment.radiance == Rgb(1.0));
}

TEST_CASE("a picture that cannot be used is told at its key, in one message") {
    const TempFolder folder;
    folder.write("sky.png", "no picture");
    const auto refused = [&](const std::string& text, const std::string& said) {
        const auto file = folder.write("a.toml", text);
        try {
            loadScene(file);
            FAIL("accepted");
        } catch (const InputError& error) {
            CAPTURE(error.text);
            CHECK(error.file == file.string());
            CHECK(error.line == 2);
            CHECK(error.column == 25);
            CHECK(error.text.find(said) != std::string::npos);
            CHECK(error.text.find('\n') == std::string::npos);
        }
    };
    const auto named = [](const std::string& image) {
        return "\nenvironment = { image = \"" + image + "\" }";
    };
    refused(named("sky.png"), (folder.path / "sky.png").string() + ": this is no PNG picture");
    refused(named("none.png"), "there is no such file, expected a PNG picture");
    refused(named("."), "this is a directory");
    refused(named("/dev/zero"), "not a regular file");
    refused(named(""), "\"image\" is empty");
    refused(named("a\\u0000b"), "control character");
    refused("\nenvironment = { image = 3 }", "\"image\" is a whole number");
    refused("\nenvironment = { image = 'sky.png', strip = [1] }", "\"image\" and \"strip\"");
    // Text that is no file has no folder.
    check("environment = { image = ^'sky.png' }", {"\"image\"", "expected \"strip\""});
}

TEST_CASE("a strip of any length survives writing and reading") {
    for (const std::size_t entries : {1u, 7u, 5000u}) {
        SceneDescription scene;
        for (std::size_t k = 0; k < entries; ++k)
            scene.environment.light.strip.emplace_back(0.1 * static_cast<double>(k), 1.0 / 3.0, 1.0);
        for (const double radiance : {0.0, 1.0, 0.3}) {
            scene.environment.light.radiance = Rgb(radiance);
            const std::string text = writeScene(scene);
            CHECK(parseScene(text, "x") == scene);
            CHECK(writeScene(parseScene(text, "x")) == text);
            CHECK((text.find("radiance") == std::string::npos) == (radiance == 1.0));
        }
    }
}

// Is every kind of material read as written, refused where it is wrong, and written so that it reads back
// equal?
#include <doctest/doctest.h>

#include <string>

#include "error_cases.h"
#include "lessons/scene_file.h"

using namespace halfdisk;

namespace {

/// The material called "m" of a file.
Material materialOf(const std::string& text) {
    const SceneDescription scene = parseScene(text, "x.toml");
    for (const NamedMaterial& named : scene.materials)
        if (named.name == "m") return named.material;
    FAIL("no material m");
    return {};
}

Material fromKeys(const std::string& keys) {
    return materialOf("[material.m]\n" + keys);
}

void check(const std::string& text, std::initializer_list<std::string_view> said) {
    checkErrors({{text, said}}, "room.toml",
                [](const std::string& scene) { parseScene(scene, "room.toml"); });
}

std::string written(const Material& material) {
    SceneDescription scene;
    scene.materials = {{"m", material}};
    const std::string text = writeScene(scene);
    CAPTURE(text);
    CHECK(parseScene(text, "written.toml") == scene);
    return text;
}

}  // namespace

TEST_CASE("each type of material has its keys and its defaults") {
    CHECK(fromKeys("") == Material(Diffuse{Rgb(0.8)}));
    CHECK(fromKeys("type = 'mirror'") == Material(Mirror{Rgb(1.0)}));
    CHECK(fromKeys("type = 'mirror'\nreflectance = [0.9, 0.8, 0.7]") == Material(Mirror{Rgb(0.9, 0.8, 0.7)}));
    CHECK(fromKeys("type = 'glossy'") == Material(Glossy{}));
    CHECK(fromKeys("type = 'glossy'\nalbedo = 0.5\nexponent = 7") == Material(Glossy{Rgb(0.5), 7.0}));
    CHECK(fromKeys("type = 'dielectric'") == Material(Dielectric{1.5, Rgb(0.0)}));
    CHECK(fromKeys("type = 'dielectric'\nior = 1\nabsorption = [0, 1, 1e6]") ==
          Material(Dielectric{1.0, Rgb(0, 1, 1e6)}));
    CHECK(fromKeys("type = 'mix'\ndiffuse = 0.5\nspecular = [1, 0.5, 0]") ==
          Material(Mix{{Rgb(0.5)}, Mirror{Rgb(1, 0.5, 0)}, 0.5}));
}

TEST_CASE("a roughness is an exponent, 1 being diffuse and 0 the sharpest lobe") {
    CHECK(fromKeys("type = 'glossy'\nroughness = 1") == Material(Glossy{Rgb(0.8), 0.0}));
    CHECK(fromKeys("type = 'glossy'\nroughness = 0") == Material(Glossy{Rgb(0.8), 1e6}));
    // n = 2 / r^2 - 2
    CHECK(fromKeys("type = 'glossy'\nroughness = 0.5") == Material(Glossy{Rgb(0.8), 6.0}));
}

TEST_CASE("the parts of a mix are colours, names or tables") {
    const std::string mix = "[material.m]\ntype = 'mix'\n";
    const Mix expected{{Rgb(0.25)}, Glossy{Rgb(0.5), 9.0}, 0.125};
    const std::string named = mix + "diffuse = 'matt'\nspecular = 'shine'\nweight = 0.125\n";
    const std::string parts =
        "[material.matt]\nalbedo = 0.25\n[material.shine]\ntype = 'glossy'\nalbedo = 0.5\nexponent = 9\n";
    CHECK(materialOf(named + parts) == Material(expected));
    CHECK(materialOf(parts + named) == Material(expected));
    CHECK(fromKeys("type = 'mix'\ndiffuse = { type = 'diffuse', albedo = 0.25 }\n"
                   "specular = { type = 'glossy', albedo = 0.5, exponent = 9 }\nweight = 0.125") ==
          Material(expected));
    CHECK(fromKeys("type = 'mix'\ndiffuse = 1\nspecular = { type = 'glossy', roughness = 0.5 }") ==
          Material(Mix{{Rgb(1.0)}, Glossy{Rgb(0.8), 6.0}, 0.5}));
    CHECK(materialOf(mix + "diffuse = 0\nspecular = 's'\n[material.s]\ntype = 'mirror'\nreflectance = 0.5") ==
          Material(Mix{{Rgb(0.0)}, Mirror{Rgb(0.5)}, 0.5}));
    CHECK(fromKeys("type = 'mix'\ndiffuse = 'default'\nspecular = 1\nweight = 1") ==
          Material(Mix{{Rgb(0.8)}, Mirror{Rgb(1.0)}, 1.0}));
    CHECK(materialOf(mix + "diffuse = 'default'\nspecular = 1\n[material.default]\nalbedo = 0.125") ==
          Material(Mix{{Rgb(0.125)}, Mirror{Rgb(1.0)}, 0.5}));
}

TEST_CASE("materials are written in one form") {
    CHECK(written(Mirror{}) == "[material.m]\ntype = \"mirror\"\n");
    CHECK(written(Mirror{Rgb(0.5)}) == "[material.m]\ntype = \"mirror\"\nreflectance = 0.5\n");
    CHECK(written(Glossy{Rgb(0.5), 1e6}) ==
          "[material.m]\ntype = \"glossy\"\nalbedo = 0.5\nexponent = 1000000.0\n");
    CHECK(written(Dielectric{}) == "[material.m]\ntype = \"dielectric\"\n");
    CHECK(written(Dielectric{1.25, Rgb(0, 1, 2)}) ==
          "[material.m]\ntype = \"dielectric\"\nior = 1.25\nabsorption = [0.0, 1.0, 2.0]\n");
    CHECK(written(Mix{{Rgb(0.5)}, Mirror{Rgb(0.75)}, 0.5}) ==
          "[material.m]\ntype = \"mix\"\ndiffuse = 0.5\nspecular = 0.75\n");
    CHECK(written(Mix{{Rgb(0, 0.5, 1)}, Glossy{Rgb(0.5), 3.0}, 0.25}) ==
          "[material.m]\ntype = \"mix\"\ndiffuse = [0.0, 0.5, 1.0]\n"
          "specular = { type = \"glossy\", albedo = 0.5, exponent = 3.0 }\nweight = 0.25\n");
    CHECK(written(Mix{{Rgb(0.5)}, Glossy{}, 0.5}) ==
          "[material.m]\ntype = \"mix\"\ndiffuse = 0.5\nspecular = { type = \"glossy\" }\n");
    // What a roughness became is kept to the last bit.
    const Material rough = fromKeys("type = 'glossy'\nroughness = 0.3");
    CHECK(std::get<Glossy>(rough).exponent == doctest::Approx(2.0 / 0.09 - 2.0));
    written(rough);
}

TEST_CASE("keys of another type are named with those of this one") {
    check("[material.m]\ntype = 'diffuse'\n^reflectance = 1",
          {"unknown key \"reflectance\" in [material.m] of type \"diffuse\"", "\"type\" or \"albedo\""});
    check("[material.m]\ntype = 'mirror'\n^albedo = 1", {"\"type\" or \"reflectance\""});
    check("[material.m]\ntype = 'mirror'\n^roughness = 0", {"of type \"mirror\""});
    check("[material.m]\ntype = 'glossy'\n^ior = 1", {"\"albedo\", \"exponent\" or \"roughness\""});
    check("[material.m]\ntype = 'glossy'\n^roughnes = 1", {"did you mean \"roughness\"?"});
    check("[material.m]\ntype = 'dielectric'\n^reflectance = 1", {"\"ior\" or \"absorption\""});
    check("[material.m]\ntype = 'mix'\ndiffuse = 1\nspecular = 1\n^albedo = 1",
          {"\"diffuse\", \"specular\" or \"weight\""});
    check("[material.m]\n^ior = 1", {"of type \"diffuse\""});
    check("[material.m]\ntype = ^'glass'",
          {"\"type\" is \"glass\"", "\"diffuse\", \"mirror\", \"glossy\", \"dielectric\" or \"mix\""});
    check("[material.m]\ntype = ^'miror'", {"did you mean \"mirror\"?"});
}

TEST_CASE("values of materials are checked") {
    check("[material.m]\ntype = 'mirror'\nreflectance = ^1.5", {"\"reflectance\" is 1.5", "from 0 to 1"});
    check("[material.m]\ntype = 'glossy'\nalbedo = ^-1", {"\"albedo\" is -1"});
    check("[material.m]\ntype = 'glossy'\nexponent = ^-0.5", {"\"exponent\" is -0.5", "from 0 to 1e6"});
    check("[material.m]\ntype = 'glossy'\nexponent = ^1000001", {"\"exponent\" is 1000001"});
    check("[material.m]\ntype = 'glossy'\nexponent = ^inf", {"\"exponent\" is inf"});
    check("[material.m]\ntype = 'glossy'\nroughness = ^1.01", {"\"roughness\" is 1.01", "from 0 to 1"});
    check("[material.m]\ntype = 'glossy'\nroughness = ^nan", {"\"roughness\" is nan"});
    check("[material.m]\ntype = 'glossy'\nexponent = 3\nroughness = ^0.5",
          {"\"roughness\" and \"exponent\"", "expected one of them"});
    check("[material.m]\ntype = 'dielectric'\nior = ^0.99", {"\"ior\" is 0.99", "from 1 to 10"});
    check("[material.m]\ntype = 'dielectric'\nior = ^11", {"\"ior\" is 11"});
    check("[material.m]\ntype = 'dielectric'\nior = ^[1, 1, 1]", {"\"ior\" is an array"});
    check("[material.m]\ntype = 'dielectric'\nabsorption = [0, 0, ^-1]", {"\"absorption\" is -1"});
    check("[material.m]\ntype = 'dielectric'\nabsorption = ^1e7", {"per metre from 0 to 1e6"});
    check("[material.m]\ntype = 'mix'\ndiffuse = 1\nspecular = 1\nweight = ^2", {"\"weight\" is 2"});
}

TEST_CASE("the parts of a mix are checked") {
    const std::string mix = "[material.m]\ntype = 'mix'\n";
    check("^" + mix + "specular = 1", {"of type \"mix\" has no \"diffuse\""});
    check("^" + mix + "diffuse = 1", {"has no \"specular\""});
    check(mix + "diffuse = ^1.5\nspecular = 1", {"\"diffuse\" is 1.5"});
    check(mix + "diffuse = 1\nspecular = [0, ^-1, 0]", {"\"specular\" is -1"});
    check(mix + "diffuse = 1\nspecular = ^[0, 1]", {"\"specular\" has 2 elements"});
    check(mix + "diffuse = ^true\nspecular = 1",
          {"\"diffuse\" is true or false", "a colour, a material's name or a table"});
    check(mix +
              "diffuse = ^'whit'\nspecular = 1\n[material.white]\nalbedo = 1\n[material.glass]\ntype = "
              "'dielectric'",
          {"no material \"whit\"", "\"white\" or \"default\"", "did you mean \"white\"?"});
    check(mix + "diffuse = 1\nspecular = ^'silver'",
          {"no material \"silver\"", "expected a colour or a table"});
    check(mix + "diffuse = 1\nspecular = ^'m2'\n[material.m2]\ntype = 'mix'\ndiffuse = 1\nspecular = 1",
          {"\"m2\" is of type \"mix\"", "\"mirror\" or \"glossy\""});
    check(mix + "diffuse = 1\nspecular = ^'m'", {"\"m\" is of type \"mix\""});
    check(mix + "diffuse = 1\nspecular = ^'glass'\n[material.glass]\ntype = 'dielectric'",
          {"\"glass\" is of type \"dielectric\""});
    check(mix + "diffuse = ^'silver'\nspecular = 1\n[material.silver]\ntype = 'mirror'",
          {"\"silver\" is of type \"mirror\"", "expected one of type \"diffuse\""});
    check(mix + "diffuse = 1\nspecular = ^'default'", {"\"default\" is of type \"diffuse\""});
    check(mix + "diffuse = 1\nspecular = ^{ exponent = 3 }",
          {"\"specular\" has no \"type\"", "\"mirror\" or \"glossy\""});
    check(mix + "diffuse = 1\nspecular = { type = ^'diffuse' }", {"\"type\" is \"diffuse\"", "\"mirror\""});
    check(mix + "diffuse = { type = ^'mirror' }\nspecular = 1", {"expected \"diffuse\""});
    check(mix + "diffuse = 1\nspecular = { type = 'mirror', ^exponent = 3 }",
          {"unknown key \"exponent\" in \"specular\" of type \"mirror\""});
    check(mix + "diffuse = { type = 'diffuse', albedo = ^2 }\nspecular = 1", {"\"albedo\" is 2"});
}

TEST_CASE("glass neither emits nor has two sides") {
    const std::string wall = "[[segment]]\na = [0, 0]\nb = [1, 0]\nmaterial = 'glass'\n";
    const std::string glass = "[material.glass]\ntype = 'dielectric'\n";
    check(wall + "emission = ^1\n" + glass, {"glass does not emit"});
    check(wall + "emission = ^[0, 0, 1e-9]\n" + glass, {"glass does not emit"});
    check(wall + "twoSided = ^true\n" + glass, {"no \"twoSided\""});
    check("[[segment]]\na = [0, 0]\nb = [1, 0]\nemission = ^1\n[material.default]\ntype = 'dielectric'",
          {"glass does not emit"});
    CHECK_NOTHROW(parseScene(wall + "emission = 0\ntwoSided = false\n" + glass, "x"));
    CHECK_NOTHROW(parseScene(wall + "emission = 1\ntwoSided = true\n[material.glass]\ntype = 'mirror'", "x"));
    // An outline may be put together from open pieces.
    CHECK_NOTHROW(
        parseScene("[[polyline]]\npoints = [[0, 0], [1, 0]]\nmaterial = 'glass'\n[[arc]]\ncenter = "
                   "[0, 0]\nradius = 1\nfrom = 0\nto = 90\nsegments = 4\nmaterial = 'glass'\n" +
                       glass,
                   "x"));
}

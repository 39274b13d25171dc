// How do Dear ImGui's draw lists become pixels with OpenGL 3.3 core?
#include "app/draw_list_renderer.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>

#include "app/imgui_compat.h"

namespace halfdisk {

namespace {

constexpr const char* kVertexShader = R"(#version 330 core
uniform vec4 display;  // left, top, width, height
in vec2 position;
in vec2 uv;
in vec4 color;
out vec2 fragmentUv;
out vec4 fragmentColor;
void main() {
    fragmentUv = uv;
    fragmentColor = color;
    vec2 p = (position - display.xy) / display.zw;
    gl_Position = vec4(2.0 * p.x - 1.0, 1.0 - 2.0 * p.y, 0.0, 1.0);
}
)";

constexpr const char* kFragmentShader = R"(#version 330 core
uniform sampler2D image;
in vec2 fragmentUv;
in vec4 fragmentColor;
out vec4 pixel;
void main() { pixel = fragmentColor * texture(image, fragmentUv); }
)";

enum Attribute : GLuint { kPosition, kUv, kColor };

void attachShader(const GlFunctions& gl, GLuint program, GLenum stage, const char* source) {
    const GLuint shader = gl.createShader(stage);
    gl.shaderSource(shader, 1, &source, nullptr);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
    gl.deleteShader(shader);  // goes with its program
    GLint compiled = 0;
    gl.getShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (compiled) return;
    std::string log(4096, '\0');
    GLsizei length = 0;
    gl.getShaderInfoLog(shader, static_cast<GLsizei>(log.size()), &length, log.data());
    log.resize(static_cast<std::size_t>(length));
    throw std::runtime_error(fmt::format("a shader does not compile: {}", log));
}

GLuint linkProgram(const GlFunctions& gl) {
    const GLuint program = gl.createProgram();
    try {
        attachShader(gl, program, GL_VERTEX_SHADER, kVertexShader);
        attachShader(gl, program, GL_FRAGMENT_SHADER, kFragmentShader);
    } catch (...) {
        gl.deleteProgram(program);
        throw;
    }
    gl.bindAttribLocation(program, kPosition, "position");
    gl.bindAttribLocation(program, kUv, "uv");
    gl.bindAttribLocation(program, kColor, "color");
    gl.linkProgram(program);
    GLint linked = 0;
    gl.getProgramiv(program, GL_LINK_STATUS, &linked);
    if (linked) return program;
    std::string log(4096, '\0');
    GLsizei length = 0;
    gl.getProgramInfoLog(program, static_cast<GLsizei>(log.size()), &length, log.data());
    log.resize(static_cast<std::size_t>(length));
    gl.deleteProgram(program);
    throw std::runtime_error(fmt::format("the shaders do not link: {}", log));
}

const void* byteOffset(std::size_t bytes) {
    return reinterpret_cast<const void*>(bytes);
}

}  // namespace

DrawListRenderer::DrawListRenderer(const GlFunctions& functions) : gl(functions), program(linkProgram(gl)) {
    displayUniform = gl.getUniformLocation(program, "display");
    textureUniform = gl.getUniformLocation(program, "image");
    gl.genVertexArrays(1, &vertexArray);
    gl.genBuffers(2, buffers);
    gl.bindVertexArray(vertexArray);
    gl.bindBuffer(GL_ARRAY_BUFFER, buffers[0]);
    gl.bindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[1]);
    constexpr GLsizei stride = sizeof(ImDrawVert);
    for (const Attribute attribute : {kPosition, kUv, kColor}) gl.enableVertexAttribArray(attribute);
    gl.vertexAttribPointer(kPosition, 2, GL_FLOAT, GL_FALSE, stride, byteOffset(offsetof(ImDrawVert, pos)));
    gl.vertexAttribPointer(kUv, 2, GL_FLOAT, GL_FALSE, stride, byteOffset(offsetof(ImDrawVert, uv)));
    gl.vertexAttribPointer(kColor, 4, GL_UNSIGNED_BYTE, GL_TRUE, stride,
                           byteOffset(offsetof(ImDrawVert, col)));
    gl.genTextures(1, &fontTexture);
    ImGui::GetIO().BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
    uploadFonts();
}

DrawListRenderer::~DrawListRenderer() {
    gl.deleteTextures(1, &fontTexture);
    for (const Upload& old : uploads) gl.deleteTextures(1, &old.texture);
    gl.deleteBuffers(2, buffers);
    gl.deleteVertexArrays(1, &vertexArray);
    gl.deleteProgram(program);
}

/// Into the texture that is bound.
void DrawListRenderer::fill(const void* pixels, int width, int height) const {
    gl.texParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl.texParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    gl.pixelStorei(GL_UNPACK_ROW_LENGTH, 0);
    gl.texImage2D(GL_TEXTURE_2D, 0, GL_RGBA, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
}

void DrawListRenderer::uploadFonts() {
    unsigned char* pixels = nullptr;
    int width = 0, height = 0;
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    atlas.GetTexDataAsRGBA32(&pixels, &width, &height);
    gl.bindTexture(GL_TEXTURE_2D, fontTexture);
    fill(pixels, width, height);
    atlas.SetTexID(textureId(fontTexture));
    atlas.ClearTexData();
}

void DrawListRenderer::upload(const Textures& textures) {
    const auto& entries = textures.entries();
    std::erase_if(uploads, [&](const Upload& old) {
        const bool kept = std::any_of(entries.begin(), entries.end(),
                                      [&](const Textures::Entry& entry) { return entry.name == old.name; });
        if (!kept) gl.deleteTextures(1, &old.texture);
        return !kept;
    });
    for (const Textures::Entry& entry : entries) {
        if (std::any_of(uploads.begin(), uploads.end(),
                        [&](const Upload& known) { return known.name == entry.name; }))
            continue;
        Upload made{entry.name, 0};
        gl.genTextures(1, &made.texture);
        uploads.push_back(made);
        gl.bindTexture(GL_TEXTURE_2D, made.texture);
        fill(entry.picture->rgba.data(), entry.picture->width, entry.picture->height);
        // Beyond its edges it is as at them, not as at the opposite ones.
        gl.texParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
        gl.texParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    }
}

void DrawListRenderer::bind(unsigned name) const {
    const auto picture =
        std::find_if(uploads.begin(), uploads.end(), [&](const Upload& known) { return known.name == name; });
    const bool premultiplied = picture != uploads.end();
    gl.bindTexture(GL_TEXTURE_2D, premultiplied ? picture->texture : name);
    gl.blendFuncSeparate(premultiplied ? GL_ONE : GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE,
                         GL_ONE_MINUS_SRC_ALPHA);
}

void DrawListRenderer::render(const ImDrawData& drawData, unsigned clearColor, const Textures& textures) {
    const float width = drawData.DisplaySize.x * drawData.FramebufferScale.x;
    const float height = drawData.DisplaySize.y * drawData.FramebufferScale.y;
    if (width <= 0.0f || height <= 0.0f) return;
    gl.viewport(0, 0, static_cast<GLsizei>(width), static_cast<GLsizei>(height));
    gl.disable(GL_SCISSOR_TEST);
    const ImVec4 clear = ImGui::ColorConvertU32ToFloat4(clearColor);
    gl.clearColor(clear.x, clear.y, clear.z, 1.0f);
    gl.clear(GL_COLOR_BUFFER_BIT);
    gl.enable(GL_SCISSOR_TEST);
    gl.disable(GL_CULL_FACE);
    gl.disable(GL_DEPTH_TEST);
    gl.enable(GL_BLEND);
    gl.blendEquation(GL_FUNC_ADD);
    gl.useProgram(program);
    gl.uniform4f(displayUniform, drawData.DisplayPos.x, drawData.DisplayPos.y, drawData.DisplaySize.x,
                 drawData.DisplaySize.y);
    gl.uniform1i(textureUniform, 0);
    gl.activeTexture(GL_TEXTURE0);
    upload(textures);
    gl.bindVertexArray(vertexArray);
    gl.bindBuffer(GL_ARRAY_BUFFER, buffers[0]);
    drawLists(drawData, height);
    gl.disable(GL_SCISSOR_TEST);
}

void DrawListRenderer::drawLists(const ImDrawData& drawData, float height) const {
    constexpr GLenum indexType = sizeof(ImDrawIdx) == 2 ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT;
    const ImVec2 origin = drawData.DisplayPos, scale = drawData.FramebufferScale;
    for (int n = 0; n < drawData.CmdListsCount; ++n) {
        const ImDrawList& list = *drawData.CmdLists[n];
        gl.bufferData(GL_ARRAY_BUFFER, list.VtxBuffer.size_in_bytes(), list.VtxBuffer.Data, GL_STREAM_DRAW);
        gl.bufferData(GL_ELEMENT_ARRAY_BUFFER, list.IdxBuffer.size_in_bytes(), list.IdxBuffer.Data,
                      GL_STREAM_DRAW);
        for (const ImDrawCmd& command : list.CmdBuffer) {
            if (command.UserCallback || command.ElemCount == 0) continue;
            const float left = std::max(0.0f, (command.ClipRect.x - origin.x) * scale.x);
            const float top = std::max(0.0f, (command.ClipRect.y - origin.y) * scale.y);
            const float right = (command.ClipRect.z - origin.x) * scale.x;
            const float bottom = std::min(height, (command.ClipRect.w - origin.y) * scale.y);
            if (right <= left || bottom <= top) continue;
            gl.scissor(static_cast<GLint>(left), static_cast<GLint>(height - bottom),
                       static_cast<GLsizei>(right - left), static_cast<GLsizei>(bottom - top));
            bind(textureName(command.GetTexID()));
            gl.drawElementsBaseVertex(GL_TRIANGLES, static_cast<GLsizei>(command.ElemCount), indexType,
                                      byteOffset(command.IdxOffset * sizeof(ImDrawIdx)),
                                      static_cast<GLint>(command.VtxOffset));
        }
    }
}

Image readFramebuffer(const GlFunctions& gl, int width, int height) {
    Image image{width, height, {}};
    const std::size_t row = std::size_t{4} * static_cast<std::size_t>(width);
    image.rgba.resize(row * static_cast<std::size_t>(height));
    gl.pixelStorei(GL_PACK_ALIGNMENT, 1);
    gl.readPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());
    for (int y = 0; y < height / 2; ++y)  // OpenGL counts rows from the bottom
        std::swap_ranges(image.at(0, y), image.at(0, y) + row, image.at(0, height - 1 - y));
    for (std::size_t opacity = 3; opacity < image.rgba.size(); opacity += 4) image.rgba[opacity] = 255;
    return image;
}

}  // namespace halfdisk

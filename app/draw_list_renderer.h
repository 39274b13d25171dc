// How do Dear ImGui's draw lists become pixels with OpenGL 3.3 core?
// The packaged OpenGL backend opens libGL.so.1 by name and so cannot start under OSMesa; this one serves both
// hosts.
#pragma once

#include <vector>

#include "app/gl_functions.h"
#include "app/png_image.h"
#include "app/textures.h"

struct ImDrawData;

namespace halfdisk {

/// Owns a shader, the buffers, the texture of the fonts and those of pictures. The GL and the ImGui context
/// that it was made in must be current whenever it is called and when it is destroyed.
class DrawListRenderer {
 public:
    /// Also tells ImGui that vertex offsets are honoured (more than 65 536 vertices in one list).
    /// Throws std::runtime_error with the compiler's log if a shader is refused.
    explicit DrawListRenderer(const GlFunctions& functions);
    ~DrawListRenderer();
    DrawListRenderer(const DrawListRenderer&) = delete;
    DrawListRenderer& operator=(const DrawListRenderer&) = delete;

    /// To be called again whenever the font atlas was rebuilt.
    void uploadFonts();

    /// Clears the framebuffer to `clearColor` (ImU32) and draws. User callbacks in the lists are skipped.
    /// `textures`: to which the lists refer besides the fonts'; each is uploaded once.
    void render(const ImDrawData& drawData, unsigned clearColor, const Textures& textures);

 private:
    struct Upload {
        unsigned name;  ///< in Textures
        GLuint texture;
    };
    void fill(const void* pixels, int width, int height) const;
    void upload(const Textures& textures);
    void bind(unsigned name) const;
    void drawLists(const ImDrawData& drawData, float height) const;

    const GlFunctions gl;
    GLuint program = 0;
    GLuint vertexArray = 0;
    GLuint buffers[2] = {};  ///< vertices, indices
    GLuint fontTexture = 0;
    std::vector<Upload> uploads;
    GLint displayUniform = -1;
    GLint textureUniform = -1;
};

/// The current framebuffer, rows from the top, opaque.
Image readFramebuffer(const GlFunctions& gl, int width, int height);

}  // namespace halfdisk

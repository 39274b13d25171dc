// Which OpenGL functions does the program call, and where do they come from?
// The program never links a GL library: window and headless host each bring the functions of their own.
#pragma once

#include <GL/glcorearb.h>

namespace halfdisk {

using GlFunction = void (*)();
/// Finds a GL function by name, null if there is none (glfwGetProcAddress, OSMesaGetProcAddress).
using GlGetProc = GlFunction (*)(const char* name);

/// The GL 3.3 core functions that the draw-list renderer needs. They belong to one context and are valid
/// while it is current.
struct GlFunctions {
    PFNGLACTIVETEXTUREPROC activeTexture = nullptr;
    PFNGLATTACHSHADERPROC attachShader = nullptr;
    PFNGLBINDATTRIBLOCATIONPROC bindAttribLocation = nullptr;
    PFNGLBINDBUFFERPROC bindBuffer = nullptr;
    PFNGLBINDTEXTUREPROC bindTexture = nullptr;
    PFNGLBINDVERTEXARRAYPROC bindVertexArray = nullptr;
    PFNGLBLENDEQUATIONPROC blendEquation = nullptr;
    PFNGLBLENDFUNCSEPARATEPROC blendFuncSeparate = nullptr;
    PFNGLBUFFERDATAPROC bufferData = nullptr;
    PFNGLCLEARPROC clear = nullptr;
    PFNGLCLEARCOLORPROC clearColor = nullptr;
    PFNGLCOMPILESHADERPROC compileShader = nullptr;
    PFNGLCREATEPROGRAMPROC createProgram = nullptr;
    PFNGLCREATESHADERPROC createShader = nullptr;
    PFNGLDELETEBUFFERSPROC deleteBuffers = nullptr;
    PFNGLDELETEPROGRAMPROC deleteProgram = nullptr;
    PFNGLDELETESHADERPROC deleteShader = nullptr;
    PFNGLDELETETEXTURESPROC deleteTextures = nullptr;
    PFNGLDELETEVERTEXARRAYSPROC deleteVertexArrays = nullptr;
    PFNGLDISABLEPROC disable = nullptr;
    PFNGLDRAWELEMENTSBASEVERTEXPROC drawElementsBaseVertex = nullptr;
    PFNGLENABLEPROC enable = nullptr;
    PFNGLENABLEVERTEXATTRIBARRAYPROC enableVertexAttribArray = nullptr;
    PFNGLGENBUFFERSPROC genBuffers = nullptr;
    PFNGLGENTEXTURESPROC genTextures = nullptr;
    PFNGLGENVERTEXARRAYSPROC genVertexArrays = nullptr;
    PFNGLGETPROGRAMINFOLOGPROC getProgramInfoLog = nullptr;
    PFNGLGETPROGRAMIVPROC getProgramiv = nullptr;
    PFNGLGETSHADERINFOLOGPROC getShaderInfoLog = nullptr;
    PFNGLGETSHADERIVPROC getShaderiv = nullptr;
    PFNGLGETUNIFORMLOCATIONPROC getUniformLocation = nullptr;
    PFNGLLINKPROGRAMPROC linkProgram = nullptr;
    PFNGLPIXELSTOREIPROC pixelStorei = nullptr;
    PFNGLREADPIXELSPROC readPixels = nullptr;
    PFNGLSCISSORPROC scissor = nullptr;
    PFNGLSHADERSOURCEPROC shaderSource = nullptr;
    PFNGLTEXIMAGE2DPROC texImage2D = nullptr;
    PFNGLTEXPARAMETERIPROC texParameteri = nullptr;
    PFNGLUNIFORM1IPROC uniform1i = nullptr;
    PFNGLUNIFORM4FPROC uniform4f = nullptr;
    PFNGLUSEPROGRAMPROC useProgram = nullptr;
    PFNGLVERTEXATTRIBPOINTERPROC vertexAttribPointer = nullptr;
    PFNGLVIEWPORTPROC viewport = nullptr;
};

/// Looks all of them up in the context that is current. Throws std::runtime_error naming the first one
/// missing.
GlFunctions loadGlFunctions(GlGetProc getProc);

}  // namespace halfdisk

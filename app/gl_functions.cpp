// How is the table of OpenGL functions filled?
#include "app/gl_functions.h"

#include <fmt/format.h>

#include <stdexcept>

namespace halfdisk {

namespace {

struct Loader {
    GlGetProc getProc;

    template <class Function>
    void operator()(Function& function, const char* name) const {
        function = reinterpret_cast<Function>(getProc(name));
        if (!function)
            throw std::runtime_error(fmt::format("this OpenGL has no {}; version 3.3 is needed", name));
    }
};

}  // namespace

GlFunctions loadGlFunctions(GlGetProc getProc) {
    const Loader load{getProc};
    GlFunctions gl;
    load(gl.activeTexture, "glActiveTexture");
    load(gl.attachShader, "glAttachShader");
    load(gl.bindAttribLocation, "glBindAttribLocation");
    load(gl.bindBuffer, "glBindBuffer");
    load(gl.bindTexture, "glBindTexture");
    load(gl.bindVertexArray, "glBindVertexArray");
    load(gl.blendEquation, "glBlendEquation");
    load(gl.blendFuncSeparate, "glBlendFuncSeparate");
    load(gl.bufferData, "glBufferData");
    load(gl.clear, "glClear");
    load(gl.clearColor, "glClearColor");
    load(gl.compileShader, "glCompileShader");
    load(gl.createProgram, "glCreateProgram");
    load(gl.createShader, "glCreateShader");
    load(gl.deleteBuffers, "glDeleteBuffers");
    load(gl.deleteProgram, "glDeleteProgram");
    load(gl.deleteShader, "glDeleteShader");
    load(gl.deleteTextures, "glDeleteTextures");
    load(gl.deleteVertexArrays, "glDeleteVertexArrays");
    load(gl.disable, "glDisable");
    load(gl.drawElementsBaseVertex, "glDrawElementsBaseVertex");
    load(gl.enable, "glEnable");
    load(gl.enableVertexAttribArray, "glEnableVertexAttribArray");
    load(gl.genBuffers, "glGenBuffers");
    load(gl.genTextures, "glGenTextures");
    load(gl.genVertexArrays, "glGenVertexArrays");
    load(gl.getProgramInfoLog, "glGetProgramInfoLog");
    load(gl.getProgramiv, "glGetProgramiv");
    load(gl.getShaderInfoLog, "glGetShaderInfoLog");
    load(gl.getShaderiv, "glGetShaderiv");
    load(gl.getUniformLocation, "glGetUniformLocation");
    load(gl.linkProgram, "glLinkProgram");
    load(gl.pixelStorei, "glPixelStorei");
    load(gl.readPixels, "glReadPixels");
    load(gl.scissor, "glScissor");
    load(gl.shaderSource, "glShaderSource");
    load(gl.texImage2D, "glTexImage2D");
    load(gl.texParameteri, "glTexParameteri");
    load(gl.uniform1i, "glUniform1i");
    load(gl.uniform4f, "glUniform4f");
    load(gl.useProgram, "glUseProgram");
    load(gl.vertexAttribPointer, "glVertexAttribPointer");
    load(gl.viewport, "glViewport");
    return gl;
}

}  // namespace halfdisk

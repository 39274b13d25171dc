// Which panels are there? Each reads the state, draws itself into the current window, and appends commands.
#pragma once

#include "app/frame.h"

namespace halfdisk {

void lessonPanel(const Ui& ui);
void controlsPanel(const Ui& ui);
void numbersPanel(const Ui& ui);
void codePanel(const Ui& ui, ImVec2 size);
void canvasPanel(const Ui& ui, ImVec2 size);
/// A row of this height (pixels); its words lie above the strip.
void eyeStrip(const Ui& ui, ImVec2 size);
/// Where the exact strip would leave too little of `room` to the canvas, it is not shown.
float eyeStripHeight(const Ui& ui, float room);
/// In place of the settings while the scene is being changed.
void editPanel(const Ui& ui);
/// A part of it: what is selected, or else the sky.
void inspector(const Ui& ui);
/// What makes the pictures, and what they cost.
void makersPanel(const Ui& ui);
/// Every sample of the run, with what it brings.
void samplesPanel(const Ui& ui, ImVec2 size);
/// Every strategy of paths from both ends, side by side.
void strategiesPanel(const Ui& ui, ImVec2 size);
/// What accuracy costs: every estimator on this scene.
void tradePanel(const Ui& ui, ImVec2 size);
/// The scene at an extreme, and what happens there.
void extremesPanel(const Ui& ui, ImVec2 size);
/// What the scene requires, and what each part costs.
void requirementsPanel(const Ui& ui, ImVec2 size);
void profilePlot(const Ui& ui, ImVec2 size);
void integrandPlot(const Ui& ui, ImVec2 size);
void errorPlot(const Ui& ui, ImVec2 size);
void histogramPlot(const Ui& ui, ImVec2 size);
void helpOverlay(const Ui& ui);
/// From `left` (pixels) to the right edge: the lesson's buttons stay in reach.
void bannerBar(const Ui& ui, float left);
/// How far what was asked for is, or that it is done.
void noticeBar(const Ui& ui, float left);
/// The list of all that can be done.
void paletteOverlay(const Ui& ui);
/// The list of files that can be opened.
void filesOverlay(const Ui& ui);

/// Keys that work wherever the pointer is, unless a text field has the keyboard.
void keyboard(const Ui& ui);

}  // namespace halfdisk

// SPDX-License-Identifier: GPL-3.0-or-later
// A recorded session: a text of what a user does, and sees, played on the real window.
//
// A line is a word and what it is about; # begins a comment.
//
//   hitos ARGUMENTS         the window, as the program opens it; always the first line
//   size 1100x700           of the window above
//   press Ctrl+O Down       keys, to what has the keyboard
//   type WORDS              the keys of these words
//   file PATH               the same in a file dialog, and Return
//   click WORDS             on what has these words, or that label, or that name in the program
//   double WORDS            twice
//   click VIEW at X Y       there in the world [m]; of what is no view, so far across and down
//   see WORDS               waits until they are written somewhere in sight
//   gone WORDS              waits until they are not
//   written FILE            waits until the file is there and holds something
//   rest                    waits until nothing is computed and all is drawn
//   drive N                 so many periods of a robot that is driven, whose clock rests
//   picture NAME.png        of the window above, into the folder HITOS_PICTURES where there is one
//   effort C clicks, K keys what all of it takes; always the last line
//
// A path begins in the sources, but for out/, a folder that goes with the session. Words are
// English; where the window speaks another language, they are what it says there for them.
#pragma once

#include <QString>

namespace hitos::window {

struct Effort {
    int clicks = 0;  ///< a double click or a drag counts as one
    int keys = 0;    ///< with Ctrl, Alt or Shift as one
    double seconds = 0.0;
};

/// Plays it; fails the test under way where something does not come true, with its line.
/// `language` counts where the session's own command line names none.
Effort play_session(const QString& file, const QString& language = "en");

/// What does not come true, having waited so long for it; empty where all does.
QString failure_of_session(const QString& file, int patience_ms, Effort* effort = nullptr,
                           const QString& language = "en");

}  // namespace hitos::window

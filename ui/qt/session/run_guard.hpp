// SPDX-License-Identifier: GPL-3.0-or-later
// Whether what a run has computed may be thrown away.
#pragma once

#include "look/prompts.hpp"
#include "session.hpp"

namespace hitos::window {

/// The one rule: a run that has computed for longer than a minute is not discarded without a
/// question, and nobody leaves a robot whose tour comes in without one.
class RunGuard {
  public:
    RunGuard(const Session& session, Prompts& prompts, QWidget* window)
        : session_(session), prompts_(prompts), window_(window) {}

    /// The run begins anew. True where little would be lost, or the user agrees.
    bool may_discard() const;
    /// Another one takes its place, of the tour that comes in or of another.
    bool may_begin(const Configuracion& next) const;
    /// It goes, with the tour that comes in.
    bool may_leave() const;
    /// Whether another run would end a tour that comes in.
    bool ends_tour(const Configuracion& next) const;
    /// What counts as long [s].
    void set_long_run(double seconds) { long_run_s_ = seconds; }

  private:
    const Session& session_;
    Prompts& prompts_;
    QWidget* window_;
    double long_run_s_ = 60.0;
};

}  // namespace hitos::window

// The window saves the results of a run, for those who have its files fail and who kill it
// (tests/faults/use).
#include <QTextStream>
#include <exception>

#include "gui_fixture.hpp"
#include "tests.hpp"

namespace hitos::window {

/// LOG SEED FOLDER; the status is 1 where the window warns of something.
int save_results_as_told(const QStringList& arguments) {
    QTextStream said(stdout);
    Fixture f(false);
    try {
        Configuracion configuration = Fixture::tour(2);
        configuration.source.file = arguments.value(0).toStdString();
        configuration.run.seed = arguments.value(1).toULongLong();
        configuration.run.threads = 1;
        configuration.grid.resolution_m = 0.5;
        f.session.set_configuration(configuration);
    } catch (const std::exception& error) {
        said << error.what() << '\n';
        return 1;
    }
    f.session.run();
    const bool ended =
        QTest::qWaitFor([&f] { return f.state() != Progress::State::running; }, kPatienceMs);
    if (!ended || f.state() != Progress::State::finished) {
        said << "the run has not come to its end\n";
        return 1;
    }
    f.prompts.saves = {arguments.value(2)};
    f.prompts.confirms = {true};
    QAction* const save = f.action("action_save_results");
    if (!QTest::qWaitFor([save] { return save->isEnabled(); }, kPatienceMs)) return 1;
    save->trigger();
    // It may be done before the window has been told.
    const bool told = QTest::qWaitFor(
        [&f] { return f.notice().contains("saved") || !f.prompts.warnings.isEmpty(); },
        kPatienceMs);
    said << f.notice() << '\n' << f.prompts.warnings.join('\n');
    return told && f.prompts.warnings.isEmpty() ? 0 : 1;
}

}  // namespace hitos::window

#include "background.hpp"

#include <sys/resource.h>

namespace hitos::window {

void let_the_window_go_first() {
    // On Linux a priority is the thread's own, whatever the name of the call says. Where it is
    // refused, the work goes on as it is.
    constexpr int kNiceness = 5;
    constexpr id_t kThisThread = 0;
    setpriority(PRIO_PROCESS, kThisThread, kNiceness);
}

}  // namespace hitos::window

// SPDX-License-Identifier: GPL-3.0-or-later
#include "map_check.hpp"

namespace hitos {

void MapStore::check(std::vector<Worker*> workers) {
    workers.push_back(&own_);
    for_each_kind([&]<class S>() {
        std::vector<typename LandmarkTable<S>::Caches*> caches;
        caches.reserve(workers.size());
        for (Worker* const worker : workers) caches.push_back(&worker->caches<S>());
        MapCheck<S>(table<S>(), caches).run();
    });
}

}  // namespace hitos

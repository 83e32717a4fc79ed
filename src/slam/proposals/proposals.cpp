// SPDX-License-Identifier: GPL-3.0-or-later
#include "proposals.hpp"

namespace hitos {

Registry<ProposalEntry>& proposals() {
    static Registry<ProposalEntry> registry("proposal", "filter.proposal",
                                            {motion_proposal(), posterior_proposal()});
    return registry;
}

}  // namespace hitos

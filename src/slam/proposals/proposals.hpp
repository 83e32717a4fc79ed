// SPDX-License-Identifier: GPL-3.0-or-later
// The proposals that Hitos brings along, one file each.
#pragma once

#include "hitos/slam/proposal.hpp"

namespace hitos {

ProposalEntry motion_proposal();
ProposalEntry posterior_proposal();

}  // namespace hitos

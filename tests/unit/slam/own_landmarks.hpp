// Landmarks of one kind that belong to a test alone.
#pragma once

#include "models/landmark_kinds.hpp"

namespace hitos {

template <class S>
class OwnLandmarks {
  public:
    typename S::Columns columns() { return {pool_, row_, cache_}; }

  private:
    typename S::Columns::Pool pool_;
    LandmarkRow row_;
    LeafCache cache_;
};

}  // namespace hitos

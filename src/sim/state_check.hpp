// Validity check of a state.
#pragma once

#include "burnish/base/status.hpp"
#include "burnish/base/views.hpp"
#include "burnish/model/model.hpp"

namespace burnish {

/// Returns Ok for a valid state (q, v), otherwise WrongSize, NotFinite or NotNormalized.
Status check_state(const Model& model, const ConstVectorRef& q, const ConstVectorRef& v) noexcept;

}  // namespace burnish

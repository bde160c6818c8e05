// Whether a state is one, answered with a status.
#pragma once

#include "burnish/base/status.hpp"
#include "burnish/base/views.hpp"
#include "burnish/model/model.hpp"

namespace burnish {

/// WrongSize, NotFinite, NotNormalized or Ok.
Status check_state(const Model& model, const ConstVectorRef& q, const ConstVectorRef& v) noexcept;

}  // namespace burnish

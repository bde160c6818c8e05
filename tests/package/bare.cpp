// Compiled without the definitions of the targets of burnish: the compiler must stop with a
// message.
#include "burnish/model/model.hpp"

// Compiled without the definitions that burnish's targets carry: must be refused, with a sentence.
#include "burnish/model/model.hpp"

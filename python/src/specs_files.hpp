// Conversion of the types of the files layer between Python and C++.
#pragma once

#include "burnish/files/problem_file.hpp"
#include "files/descriptions.gen.hpp"
#include "specs_ocp.hpp"
#include "specs_solver.hpp"

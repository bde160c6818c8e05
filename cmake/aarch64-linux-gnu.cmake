# Toolchain for 64-bit ARM with Debian's cross compiler; programs run in QEMU. CMake searches libraries for ARM
# only in BURNISH_AARCH64_PREFIX, but headers everywhere, because Eigen has only headers.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_C_COMPILER aarch64-linux-gnu-gcc)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-aarch64 -L /usr/aarch64-linux-gnu)
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES BURNISH_AARCH64_PREFIX)
set(CMAKE_FIND_ROOT_PATH "${BURNISH_AARCH64_PREFIX}" /usr/share/eigen3)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)

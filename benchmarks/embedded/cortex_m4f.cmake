# Toolchain for CMake: a Cortex-M4 with a single-precision FPU and newlib, tests run by QEMU.
#
#   cmake -S FOLDER -B build -DCMAKE_TOOLCHAIN_FILE=cortex_m4f.cmake && cmake --build build
#   ctest --test-dir build
#
# The board is QEMU's netduinoplus2: an STM32F405 with 1 MB of flash and 128 KB of RAM.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR arm)
set(CMAKE_C_COMPILER arm-none-eabi-gcc)
# There is nothing to link a program to before the flags below are known.
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)

set(CMAKE_C_FLAGS_INIT "-mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16")
string(APPEND CMAKE_C_FLAGS_INIT " -ffunction-sections -fdata-sections -fstack-usage")
set(CMAKE_EXE_LINKER_FLAGS_INIT "--specs=rdimon.specs -nostartfiles -Wl,--gc-sections")
string(APPEND CMAKE_EXE_LINKER_FLAGS_INIT
  " -T \"${CMAKE_CURRENT_LIST_DIR}/stm32f405.ld\" \"${CMAKE_CURRENT_LIST_DIR}/startup.c\"")

# What is printed and the exit code go through semihosting. A hang ends as a failure.
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-system-arm -machine netduinoplus2 -nographic -monitor none
  -serial none -semihosting-config enable=on,target=native -kernel)

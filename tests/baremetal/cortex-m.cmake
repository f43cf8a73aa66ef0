# Toolchain file: the tests as images for an emulated LM3S6965EVB board with the core named by FIXCAST_CPU.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR arm)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
set(CMAKE_TRY_COMPILE_PLATFORM_VARIABLES FIXCAST_CPU)
set(CMAKE_C_COMPILER arm-none-eabi-gcc)
set(CMAKE_C_FLAGS_INIT "-mcpu=${FIXCAST_CPU} -mthumb -O2")
set(CMAKE_EXECUTABLE_SUFFIX .elf)
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)

# Own start-up and linker script. newlib serves memcpy, memset and setjmp; there are no system calls, so anything
# bigger would not link. That the core needs no more than memcpy and memset is checked on its objects.
set(CMAKE_EXE_LINKER_FLAGS_INIT
  "-nostartfiles -Wl,--gc-sections -T ${CMAKE_CURRENT_LIST_DIR}/lm3s6965.ld")

# The image's output and exit code come out through semihosting.
set(CMAKE_CROSSCOMPILING_EMULATOR
  qemu-system-arm -M lm3s6965evb -cpu ${FIXCAST_CPU} -display none -nic none -monitor none -serial none
  -chardev stdio,id=output -semihosting-config enable=on,target=native,chardev=output -kernel)

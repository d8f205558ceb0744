# The simulator's loops, once an instruction set, so that a binary built on one x86-64 machine runs on another and
# still uses its registers. The rest of the program is compiled for the baseline.
#
# A variant must not lend its code: inline functions that it shares with others are weak symbols, of which the linker
# would keep any one, say that with AVX-512. So each variant is linked by itself first, and all of its symbols but its
# Kernel are made local.
# The linker and objcopy are those of GNU binutils; CMake would take LLVM's beside clang, which cannot do this.
find_program(TRUNK_LD NAMES ld.bfd ld REQUIRED)
find_program(TRUNK_OBJCOPY NAMES objcopy REQUIRED)

function(trunk_kernel name instructions lanes)
  set(library trunk_kernel_${name})
  add_library(${library} OBJECT dynamics/kernel_variant.cpp)
  target_compile_definitions(${library} PRIVATE TRUNK_KERNEL=kernel_${name}
    TRUNK_KERNEL_INSTRUCTIONS="${instructions}" TRUNK_KERNEL_LANES=${lanes})
  target_compile_options(${library} PRIVATE ${ARGN})
  target_link_libraries(${library} PRIVATE $<TARGET_PROPERTY:trunk_dynamics,LINK_LIBRARIES>)
  target_include_directories(${library} PRIVATE $<TARGET_PROPERTY:trunk_dynamics,INCLUDE_DIRECTORIES>)
  if(TRUNK_SANITIZE)
    target_sources(trunk_dynamics PRIVATE $<TARGET_OBJECTS:${library}>)
    return()
  endif()
  set(sealed ${CMAKE_CURRENT_BINARY_DIR}/kernel_${name}.o)
  add_custom_command(OUTPUT ${sealed}
    COMMAND ${TRUNK_LD} -r --force-group-allocation $<TARGET_OBJECTS:${library}> -o ${sealed}
    COMMAND ${TRUNK_OBJCOPY} --wildcard --keep-global-symbol=*kernel_${name}* ${sealed}
    DEPENDS $<TARGET_OBJECTS:${library}> COMMAND_EXPAND_LISTS VERBATIM)
  target_sources(trunk_dynamics PRIVATE ${sealed})
  set_property(GLOBAL APPEND PROPERTY TRUNK_SEALED_KERNELS ${sealed})
  set_source_files_properties(${sealed} PROPERTIES EXTERNAL_OBJECT TRUE GENERATED TRUE)
endfunction()

trunk_kernel(baseline "baseline" 2)
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64" AND NOT TRUNK_SANITIZE)
  target_compile_definitions(trunk_dynamics PRIVATE TRUNK_X86_KERNELS)
  trunk_kernel(avx2 "AVX2" 4 -mavx2 -mbmi2)
  trunk_kernel(avx512 "AVX-512" 8 -mavx2 -mbmi2 -mavx512f -mavx512dq -mavx512vl)
endif()

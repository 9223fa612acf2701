# How a process is made to run as on a narrower processor: luxgate and Embree by LUXGATE_ISA, glibc by its tunables.

set(without_avx512 -AVX512F,-AVX512VL,-AVX512BW,-AVX512DQ,-AVX512CD)
set(without_avx2 ${without_avx512},-AVX2,-FMA,-FMA4,-BMI1,-BMI2)
set(without_avx ${without_avx2},-AVX)
set(as_avx512 --unset=GLIBC_TUNABLES LUXGATE_ISA=avx512)
set(as_avx2 LUXGATE_ISA=avx2 GLIBC_TUNABLES=glibc.cpu.hwcaps=${without_avx512})
set(as_avx LUXGATE_ISA=avx GLIBC_TUNABLES=glibc.cpu.hwcaps=${without_avx2})
set(as_sse4.2 LUXGATE_ISA=sse4.2 GLIBC_TUNABLES=glibc.cpu.hwcaps=${without_avx})
set(as_ssse3 LUXGATE_ISA=ssse3 GLIBC_TUNABLES=glibc.cpu.hwcaps=${without_avx},-SSE4_2,-SSE4_1)
set(as_sse2 LUXGATE_ISA=sse2 GLIBC_TUNABLES=glibc.cpu.hwcaps=${without_avx},-SSE4_2,-SSE4_1,-SSSE3)

# Sets version (the answer of `luxgate version --json`) and instruction_sets: those of this processor, all of which must
# really be chosen when asked for.
macro(find_instruction_sets)
  execute_process(COMMAND ${CMAKE_COMMAND} -E env --unset=LUXGATE_ISA ${LUXGATE} version --json
    OUTPUT_VARIABLE version RESULT_VARIABLE code)
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "version --json: exit code ${code}")
  endif()
  string(JSON count LENGTH "${version}" instruction_sets)
  math(EXPR last "${count} - 1")
  set(instruction_sets "")
  foreach(k RANGE ${last})
    string(JSON isa GET "${version}" instruction_sets ${k})
    list(APPEND instruction_sets ${isa})
    if(NOT DEFINED as_${isa})
      message(FATAL_ERROR "processors.cmake does not know ${isa}")
    endif()
  endforeach()
endmacro()

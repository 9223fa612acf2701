# A table of somebody's own becomes a pack, the pack is linted, and planes are held against it: each row judges planes
# where its task is, and no others.
#   cmake -DLUXGATE=<binary> -DFOLDER=<tests/own_table> -DWORK=<scratch> -P run_own_table.cmake
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/luxgate_runs.cmake)

clear_work()
run_in_work(0 rules import ${FOLDER}/table.csv --id own -o own.xml)
expect_in("${out}" "Wrote own.xml: 4 rows, 1 of them on the floor, 1 of them upright")
run_in_work(0 rules lint own.xml)
expect_in("${out}" "own.xml: no error (own:2021: 4 rows, 18 checks)")

run_in_work(0 rules show own A.1 --rules own.xml)
expect_in("${out}" "plane for role task: horizontal-up, 0 to 0.2 m above the floor in this row, grid formula")
run_in_work(0 rules show own A.3 --rules own.xml)
expect_in("${out}" "plane for role task: vertical, 0.3 to 2 m above the floor in this row, grid formula")
expect_in("${out}" "The row has no value for the roles: wall, ceiling, cylinder\n")

# 2: some planes are not judged.
run_in_work(2 check --rules own.xml --seed 1 --format csv ${FOLDER}/project.xml)
foreach(plane floor bench shelf)
  if(NOT out MATCHES "corridor,${plane},[^\n]*,pass,")
    message(SEND_ERROR "plane ${plane} does not pass\n${out}")
  endif()
endforeach()
foreach(plane floor-at-desk-height bench-on-the-floor shelf-lying)
  if(NOT out MATCHES "corridor,${plane},[^\n]*,not judged," OR out MATCHES "corridor,${plane},[^\n]*,(pass|fail),")
    message(SEND_ERROR "plane ${plane} is judged\n${out}")
  endif()
endforeach()

run_in_work(2 check --rules own.xml ${FOLDER}/wrong-role.xml)
expect_in("${err}" "row 'A.4' requires nothing of the role 'task'")

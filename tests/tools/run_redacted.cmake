# Reports that are given away: with --redact the same projects in two folders give the same bytes in every format, and no
# format names the folders; 'report' redacts a result as 'check' does. Without a change of folder, a date does the same.
#   cmake -DLUXGATE=<binary> -DEXAMPLE=<folder> -DWORK=<scratch> -P run_redacted.cmake
cmake_minimum_required(VERSION 3.25)

file(REMOVE_RECURSE ${WORK})
set(first ${WORK}/anna-laptop/office)
set(second ${WORK}/benno-server/a/designs)
# Two projects of one name, one whose photometry is missing, one that is no XML; another is not there at all.
foreach(folder ${first} ${second})
  file(COPY ${EXAMPLE}/ DESTINATION ${folder})
  file(COPY ${EXAMPLE}/ DESTINATION ${folder}/second)
  file(READ ${EXAMPLE}/project.xml text)
  string(REGEX REPLACE "photometry=\"[^\"]*\"" "photometry=\"photometry/nowhere.ies\"" text "${text}")
  file(WRITE ${folder}/missing.xml "${text}")
  file(WRITE ${folder}/broken.xml "<luxgate")
endforeach()

# Runs LUXGATE in `where`, `projects` behind the options; what is on standard output goes to out.txt.
function(check where expected output)
  execute_process(COMMAND ${CMAKE_COMMAND} -E env --unset=SOURCE_DATE_EPOCH ${LUXGATE} ${ARGN}
    --format csv=${output}/results.csv --format points-csv=${output}/points.csv --format json=${output}/result.json
    --format html=${output}/report.html --format junit=${output}/junit.xml --format sarif=${output}/problems.sarif
    --format sarif-all=${output}/all.sarif --format github=${output}/github.txt --format gitlab=${output}/gitlab.json
    --format markdown=${output}/summary.md --format xlsx=${output}/result.xlsx
    WORKING_DIRECTORY ${where} RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE err)
  if(NOT code EQUAL expected)
    list(JOIN ARGN " " words)
    message(FATAL_ERROR "${words}: exit code ${code}, expected ${expected}\n${out}${err}")
  endif()
  file(WRITE ${output}/out.txt "${out}")
endfunction()

function(expect_equal a b)
  file(GLOB names RELATIVE ${a} ${a}/*)
  list(LENGTH names count)
  if(NOT count EQUAL 12)
    message(SEND_ERROR "${a} has ${count} files, 12 formats were asked for")
  endif()
  foreach(name ${names})
    file(SHA256 ${a}/${name} one)
    file(SHA256 ${b}/${name} other)
    if(NOT one STREQUAL other)
      message(SEND_ERROR "${name} differs between ${a} and ${b}")
    endif()
  endforeach()
endfunction()

set(options --pictures off --tolerance 0.1)
check(${WORK} 2 ${WORK}/1 check --redact ${options} ${first}/project.xml ${first}/second/project.xml ${first}/missing.xml
  ${first}/broken.xml ${first}/absent.xml)
check(${second} 2 ${WORK}/2 check --redact ${options} project.xml second/project.xml missing.xml broken.xml absent.xml)
check(${WORK} 2 ${WORK}/3 check --redact ${options} benno-server/a/designs/project.xml
  ./benno-server/a/designs/second/project.xml benno-server/a/designs/missing.xml benno-server/a/designs/../designs/broken.xml
  benno-server/a/designs/absent.xml)
expect_equal(${WORK}/1 ${WORK}/2)
expect_equal(${WORK}/1 ${WORK}/3)

# A result that still holds the paths, redacted later.
check(${WORK} 2 ${WORK}/plain check ${options} ${first}/project.xml ${first}/second/project.xml ${first}/missing.xml
  ${first}/broken.xml ${first}/absent.xml)
check(${WORK} 0 ${WORK}/later report --redact ${WORK}/plain/result.json)
check(${WORK} 0 ${WORK}/twice report --redact ${WORK}/later/result.json)
expect_equal(${WORK}/1 ${WORK}/later)
expect_equal(${WORK}/1 ${WORK}/twice)

# What is searched for can be found, or finding nothing would prove nothing.
foreach(format result.json report.html junit.xml all.sarif github.txt gitlab.json summary.md results.csv points.csv out.txt)
  file(READ ${WORK}/plain/${format} plain)
  file(READ ${WORK}/1/${format} redacted)
  if(NOT plain MATCHES "anna-laptop")
    message(SEND_ERROR "${format} has no folder even without --redact")
  endif()
  foreach(word anna-laptop benno-server "/office/" designs)
    if(redacted MATCHES "${word}")
      message(SEND_ERROR "${format} names ${word}")
    endif()
  endforeach()
  if(NOT format MATCHES "csv|gitlab" AND NOT format STREQUAL "result.json" AND NOT redacted MATCHES "Omitted: folders of files")
    message(SEND_ERROR "${format} does not say that paths were left out")
  endif()
endforeach()
file(READ ${WORK}/1/result.json result)
foreach(word "\"redacted\": true" "luxgate check project1/project.xml project2/project.xml missing.xml broken.xml absent.xml"
  "'photometry/nowhere.ies'")
  if(NOT result MATCHES "${word}")
    message(SEND_ERROR "result.json has no ${word}")
  endif()
endforeach()

# Dates: the option and the variable of reproducible builds say the same, and a second time the same bytes.
check(${WORK} 2 ${WORK}/date1 check ${options} --timestamp 1700000000 ${first}/project.xml ${first}/broken.xml)
check(${WORK} 2 ${WORK}/date2 check ${options} --timestamp 1700000000 ${first}/project.xml ${first}/broken.xml)
expect_equal(${WORK}/date1 ${WORK}/date2)
file(READ ${WORK}/date1/report.html html)
if(NOT html MATCHES "2023-11-14T22:13:20Z")
  message(SEND_ERROR "report.html has no date")
endif()
execute_process(COMMAND ${CMAKE_COMMAND} -E env SOURCE_DATE_EPOCH=1700000000 ${LUXGATE} check ${options} --quiet
  ${first}/project.xml ${first}/broken.xml --format html=${WORK}/epoch.html --format json=${WORK}/epoch.json
  RESULT_VARIABLE code OUTPUT_QUIET ERROR_QUIET)
foreach(pair "epoch.html;date1/report.html" "epoch.json;date1/result.json")
  list(GET pair 0 made)
  list(GET pair 1 expected)
  execute_process(COMMAND ${CMAKE_COMMAND} -E compare_files ${WORK}/${made} ${WORK}/${expected} RESULT_VARIABLE differs)
  if(differs)
    message(SEND_ERROR "${made} differs from ${expected}")
  endif()
endforeach()

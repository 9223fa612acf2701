# Reports of examples before axe-core, an independent checker of accessibility, in a real browser, light and dark. axe-core
# is not part of this tree: the environment variable LUXGATE_AXE names its axe.min.js; without it the test is skipped.
#   cmake -DBROWSER=<chromium> -DLUXGATE=<binary> -DMAKE=<make_reports> -DEXAMPLES=<folder> -DWORK=<scratch> -P run_axe.cmake
cmake_minimum_required(VERSION 3.25)

if("$ENV{LUXGATE_AXE}" STREQUAL "")
  message("skipped: LUXGATE_AXE does not name an axe.min.js")
  return()
endif()
file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK}/pages)
file(READ $ENV{LUXGATE_AXE} axe)

# As it is read by the probes of the other browser test: one line that begins with a word.
set(probe "
addEventListener('load', function () {
  document.querySelectorAll('details').forEach(function (part) { part.open = true; });
  axe.run(document, { resultTypes: ['violations'] }).then(function (result) {
    var lines = result.violations.map(function (found) {
      return found.id + ' (' + found.impact + ', ' + found.nodes.length + '): ' + found.nodes.slice(0, 3).map(function (node) {
        return node.target.join(' ') + ' ' + node.failureSummary.replace(/\\s+/g, ' ').slice(0, 200);
      }).join(' / ');
    });
    var pre = document.createElement('pre');
    pre.textContent = 'AXE ' + axe.version + ': ' + result.passes.length + ' rules kept, ' + lines.length + ' broken' +
      lines.map(function (line) { return '\\n' + line; }).join('') + '\\nEND OF AXE';
    document.body.appendChild(pre);
  });
});")

# The policy of the page allows its own script only: the copy that is examined has none.
function(examine name html)
  string(REGEX REPLACE "<meta http-equiv=\"Content-Security-Policy\"[^>]*>" "" page "${html}")
  if(page STREQUAL html)
    message(SEND_ERROR "${name}: no content security policy")
  endif()
  string(REPLACE "</body>" "<script>${axe}</script><script>${probe}</script></body>" page "${page}")
  file(WRITE ${WORK}/pages/${name}.html "${page}")
  foreach(scheme light dark)
    set(options --window-size=1300,1000 --virtual-time-budget=60000)
    if(scheme STREQUAL dark)
      list(APPEND options --blink-settings=preferredColorScheme=0)
    endif()
    execute_process(COMMAND ${BROWSER} --headless --no-sandbox --disable-gpu --disable-quic --no-first-run
      --disable-background-networking --disable-component-update --disable-sync --user-data-dir=${WORK}/profile ${options}
      --dump-dom file://${WORK}/pages/${name}.html TIMEOUT 120 RESULT_VARIABLE code OUTPUT_VARIABLE dom ERROR_QUIET)
    string(REGEX MATCH "AXE [0-9][^<]*END OF AXE" told "${dom}")
    message(STATUS "${name}, ${scheme}: ${told}")
    if(NOT told MATCHES "^AXE [0-9.]+: [1-9][0-9]* rules kept, 0 broken")
      message(SEND_ERROR "${name}, ${scheme}: browser ended with ${code}: ${told}")
    endif()
  endforeach()
endfunction()

foreach(example 02-direct-and-indirect 05-failing-corridor 09-office-by-row)
  execute_process(COMMAND ${LUXGATE} check --quiet --tolerance 0.2 ${EXAMPLES}/${example}/project.xml
    --format html=${WORK}/${example}.html OUTPUT_QUIET ERROR_QUIET)
  file(READ ${WORK}/${example}.html html)
  examine(${example} "${html}")
endforeach()
file(WRITE ${WORK}/none.js "")
execute_process(COMMAND ${MAKE} ${WORK} ${WORK}/none.js COMMAND_ERROR_IS_FATAL ANY OUTPUT_QUIET)
foreach(page two split hostile)
  file(READ ${WORK}/${page}.html html)
  examine(${page} "${html}")
endforeach()

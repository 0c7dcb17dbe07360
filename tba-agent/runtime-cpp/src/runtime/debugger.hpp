#pragma once

namespace sitaf::runtime {

/// Waits until a debugger traces this process, if the environment variable SITAF_DEBUGGER names a folder. Creates the file `waiting` there;
/// a file `continue` ends the wait without a debugger.
void waitForDebugger();

}  // namespace sitaf::runtime

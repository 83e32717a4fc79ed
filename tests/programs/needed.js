// SPDX-License-Identifier: GPL-3.0-or-later
// What a test's script cannot do without.
'use strict';

/// The modules; ends the script with the status that its test takes for "skip" where one is missing.
exports.modules = (names) => names.map((name) => {
  try {
    return require(name);
  } catch {
    console.log(`node's package ${name} is missing (npm install --global, or NODE_PATH)`);
    return process.exit(77);
  }
});

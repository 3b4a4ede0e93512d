// A bracket with a square hole: genus 1; no curved faces, so that its volume is known.
difference() {
  union() {
    cube([120, 60, 10]);
    cube([10, 60, 80]);
  }
  translate([60, 20, -1]) cube([30, 20, 12]);
}

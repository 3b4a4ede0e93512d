package main

import "math"

// A Felt is what was felt of a cell of a patch: a code, or the chances of all codes.
type Felt struct {
	at      Offset
	code    int
	chances []float64
}

func offsetsOf(patch []Felt) []Offset {
	offsets := make([]Offset, len(patch))
	for k, felt := range patch {
		offsets[k] = felt.at
	}
	return offsets
}

// locate finds the positions at which every cell agrees, by way of the complete windows.
func (a *Array) locate(patch []Felt) ([]Offset, error) {
	if len(patch) == 0 {
		return nil, refusal("too-few-cells")
	}
	windows := a.completeWindows(patch)
	if len(windows) == 0 {
		return nil, refusal("no-complete-window")
	}
	// Where every cell agrees every complete window occurs, so that these are the common places of
	// the windows that occur, as far as all other cells agree there too.
	if found := a.within(patch, 0); len(found) > 0 {
		return found, nil
	}
	return nil, a.whyNowhere(patch, windows)
}

// nearest finds the positions that differ in the fewest cells, if these are at most so many; a
// negative radius stands for as many as are corrected for certain.
func (a *Array) nearest(patch []Felt, radius int) ([]Offset, error) {
	if len(patch) == 0 {
		return nil, refusal("too-few-cells")
	}
	if radius < 0 {
		radius = 0
		if a.surface == sheet || a.surface == a.ownSurface() {
			radius = (a.distance(offsetsOf(patch)) - 1) / 2 // of 0 this is 0
		}
	}
	if found := a.within(patch, radius); len(found) > 0 {
		return found, nil
	}
	windows, nonzero := a.completeWindows(patch), 0
	for _, felt := range patch {
		if felt.code != 0 {
			nonzero++
		}
	}
	switch {
	case radius == 0 && len(windows) > 0:
		return nil, a.whyNowhere(patch, windows)
	case nonzero <= radius:
		return nil, refusal("zero-window")
	case radius == 0:
		return nil, refusal("contradiction")
	}
	return nil, refusal("beyond-radius")
}

// within has the nearest positions, ascending, if they differ in no more cells than the radius.
func (a *Array) within(patch []Felt, radius int) []Offset {
	var found []Offset
	least := radius
	a.visit(a.surface, offsetsOf(patch), func(at Offset, content []int) {
		differences := 0
		for k, c := range content {
			if c != patch[k].code {
				if differences++; differences > least {
					return
				}
			}
		}
		if differences < least {
			least, found = differences, found[:0]
		}
		found = append(found, at)
	})
	return found
}

// completeWindows has each complete window as a patch of its own; the first cell tells its offset.
func (a *Array) completeWindows(patch []Felt) [][]Felt {
	known := map[Offset]int{}
	for _, felt := range patch {
		known[felt.at] = felt.code
	}
	var windows [][]Felt
	for _, felt := range patch {
		var window []Felt
		for _, o := range a.rectangle() {
			at := Offset{felt.at.row + o.row, felt.at.column + o.column}
			code, ok := known[at]
			if !ok {
				break
			}
			window = append(window, Felt{at: at, code: code})
		}
		if len(window) == a.k1*a.k2 {
			windows = append(windows, window)
		}
	}
	return windows
}

// whyNowhere is the reason for which a patch with complete windows is nowhere.
func (a *Array) whyNowhere(patch []Felt, windows [][]Felt) error {
	common, occurring, zeros := map[Offset]int{}, 0, true
	for _, window := range windows {
		corner := window[0].at
		upright := make([]Felt, len(window))
		for k, felt := range window {
			upright[k] = Felt{at: Offset{felt.at.row - corner.row, felt.at.column - corner.column},
				code: felt.code}
			zeros = zeros && felt.code == 0
		}
		found := a.within(upright, 0)
		if len(found) > 0 {
			occurring++
		}
		for _, at := range found {
			common[Offset{at.row - corner.row, at.column - corner.column}]++
		}
	}
	if occurring == 0 && zeros {
		return refusal("zero-window")
	}
	if occurring == 0 {
		return refusal("not-in-array")
	}
	for at, count := range common {
		// What lies on the sheet agrees; the patch is nowhere because something does not.
		if a.surface == sheet && count == occurring && a.agreesOnSheet(patch, at) {
			return refusal("off-sheet")
		}
	}
	return refusal("contradiction")
}

func (a *Array) agreesOnSheet(patch []Felt, at Offset) bool {
	for _, felt := range patch {
		place := a.canonical(sheet, at.row+felt.at.row, at.column+felt.at.column)
		if place >= 0 && a.cells[place] != felt.code {
			return false
		}
	}
	return true
}

// posterior is Bayes' theorem: all positions are equally likely beforehand, cells are independent.
func (a *Array) posterior(patch []Felt) ([][3]float64, error) {
	var ranking [][3]float64 // with logarithms at first
	best := math.Inf(-1)
	a.visit(a.surface, offsetsOf(patch), func(at Offset, content []int) {
		likelihood := 0.0
		for k, c := range content {
			likelihood += math.Log(patch[k].chances[c])
		}
		if likelihood > math.Inf(-1) {
			ranking = append(ranking, [3]float64{float64(at.row), float64(at.column), likelihood})
			best = math.Max(best, likelihood)
		}
	})
	if len(ranking) == 0 {
		return nil, refusal("contradiction")
	}
	total := 0.0
	for k := range ranking {
		ranking[k][2] = math.Exp(ranking[k][2] - best)
		total += ranking[k][2]
	}
	for k := range ranking {
		ranking[k][2] /= total
	}
	return ranking, nil
}

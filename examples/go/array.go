package main

// A Profile states every convention on which implementations could differ.
type Profile struct {
	q                          int
	modulus, polynomial, state []int
	n1, n2, k1, k2             int
	reciprocal                 bool
	rowMajor                   bool
	surface                    string
	leastFirst                 bool
}

const (
	torus        = "torus"
	twistedTorus = "twisted-torus"
	sheet        = "sheet"
)

// An Array is one period of an m-sequence, folded into n1 x n2 cells.
type Array struct {
	Profile
	field *Field
	size  int
	terms []int
	cells []int // row by row
	steps int   // the inverse of n1 modulo n2
}

// An Offset is of a cell from a position.
type Offset struct{ row, column int }

// NewArray checks a profile.
func NewArray(p Profile) (*Array, error) {
	field, err := NewField(p.q, p.modulus)
	if err != nil {
		return nil, err
	}
	for len(p.polynomial) > 0 && p.polynomial[len(p.polynomial)-1] == 0 {
		p.polynomial = p.polynomial[:len(p.polynomial)-1]
	}
	n := len(p.polynomial) - 1
	if !areCodes(p.polynomial, p.q) || !areCodes(p.state, p.q) || !anyNonzero(p.state) ||
		n < 1 || len(p.state) != n || p.polynomial[n] != 1 || !isPeriod(p.q, n, p.n1, p.n2) {
		return nil, errImpossible
	}
	a := &Array{Profile: p, field: field, size: p.n1 * p.n2, steps: inverseModulo(p.n1, p.n2)}
	if p.k1 < 1 || p.k2 < 1 || p.k1 > 4096 || p.k1*p.k2 > 4096 ||
		!p.rowMajor && a.steps == 0 && p.n2 > 1 || !field.isPrimitive(p.polynomial) {
		return nil, errImpossible
	}
	a.fill(characteristic(field, p))
	return a, nil
}

func areCodes(codes []int, q int) bool {
	for _, c := range codes {
		if c >= q {
			return false
		}
	}
	return true
}

func anyNonzero(codes []int) bool {
	for _, c := range codes {
		if c != 0 {
			return true
		}
	}
	return false
}

// isPeriod tells whether n1 n2 = q^n - 1, of at most 2^24 cells.
func isPeriod(q, n, n1, n2 int) bool {
	power := 1
	for k := 0; k < n && power <= 1<<24; k++ {
		power *= q
	}
	return n1 > 0 && n2 > 0 && n1 <= (power-1)/n2 && n1*n2 == power-1
}

// inverseModulo is 0 if there is none, or if n is 1.
func inverseModulo(a, n int) int {
	for b := 1; b < n; b++ {
		if a%n*b%n == 1 {
			return b
		}
	}
	return 0
}

// characteristic is the polynomial, or its reciprocal x^n h(1/x), made monic.
func characteristic(f *Field, p Profile) []int {
	if !p.reciprocal {
		return p.polynomial
	}
	n := len(p.polynomial) - 1
	h := make([]int, n+1)
	for k := range h {
		h[k] = f.multiply(f.inverse(p.polynomial[0]), p.polynomial[n-k])
	}
	return h
}

// fill computes s(i + n) = - (c0 s(i) + ... + c(n-1) s(i+n-1)), mind the minus, and folds it.
func (a *Array) fill(h []int) {
	n := len(h) - 1
	a.terms = append([]int{}, a.state...)
	for i := 0; len(a.terms) < a.size; i++ {
		sum := 0
		for k := 0; k < n; k++ {
			sum = a.field.add(sum, a.field.multiply(h[k], a.terms[i+k]))
		}
		a.terms = append(a.terms, a.field.negatives[sum])
	}
	a.terms = a.terms[:a.size]
	for r := 0; r < a.n1; r++ {
		for c := 0; c < a.n2; c++ {
			a.cells = append(a.cells, a.terms[a.index(r, c)])
		}
	}
}

// index tells which term a cell holds; beyond the edges on the folding's own surface.
func (a *Array) index(row, column int) int {
	if a.rowMajor {
		return (a.n2*row + column) % a.size
	}
	row %= a.n1 // i = row modulo n1 and i = column modulo n2: the Chinese remainder theorem
	apart := (column%a.n2 + a.n2 - row%a.n2) % a.n2
	return row + a.n1*(apart*a.steps%a.n2)
}

// ownSurface is the one on which the neighbours of all cells are alike.
func (a *Array) ownSurface() string {
	if a.rowMajor {
		return twistedTorus
	}
	return torus
}

// canonical is the cell that a row and a column, perhaps negative, are on a surface: its number, row
// by row; -1 beyond the edges of the sheet.
func (a *Array) canonical(surface string, row, column int) int {
	mod := func(x, n int) int { return (x%n + n) % n }
	switch surface {
	case torus:
		return mod(row, a.n1)*a.n2 + mod(column, a.n2)
	case twistedTorus:
		return mod(row*a.n2+column, a.size)
	}
	if row < 0 || row >= a.n1 || column < 0 || column >= a.n2 {
		return -1
	}
	return row*a.n2 + column
}

// window is what cells hold from a position; nil if one of them does not lie on the surface.
func (a *Array) window(surface string, at Offset, offsets []Offset, content []int) []int {
	content = content[:0]
	for _, o := range offsets {
		place := a.canonical(surface, at.row+o.row, at.column+o.column)
		if place < 0 {
			return nil
		}
		content = append(content, a.cells[place])
	}
	return content
}

// visit calls for each position from which the cells lie on the surface, with what they hold there.
func (a *Array) visit(surface string, offsets []Offset, each func(at Offset, content []int)) {
	content := make([]int, 0, len(offsets)+1)
	for r := 0; r < a.n1; r++ {
		for c := 0; c < a.n2; c++ {
			if found := a.window(surface, Offset{r, c}, offsets, content); found != nil {
				each(Offset{r, c}, found)
			}
		}
	}
}

// rectangle has the offsets of the profile's window, in reading order.
func (a *Array) rectangle() []Offset {
	var offsets []Offset
	for i := 0; i < a.k1; i++ {
		for j := 0; j < a.k2; j++ {
			offsets = append(offsets, Offset{i, j})
		}
	}
	return offsets
}

// A Proof says whether all windows of a mask differ.
type Proof struct {
	Proved  bool `json:"proved"`
	Rank    *int `json:"rank"`
	Windows int  `json:"windows"`
}

// prove counts contents on the profile's surface; false if no window lies on it.
func (a *Array) prove(mask []Offset) (Proof, bool) {
	contents, windows := map[string]bool{}, 0
	a.visit(a.surface, mask, func(_ Offset, content []int) {
		key := make([]byte, len(content))
		for k, c := range content {
			key[k] = byte(c)
		}
		contents[string(key)] = true
		windows++
	})
	proof := Proof{Proved: len(contents) == windows, Windows: len(contents)}
	if a.surface == sheet || a.surface == a.ownSurface() {
		rank := a.rank(mask)
		proof.Rank = &rank
	}
	return proof, windows > 0
}

// rank is that of the windows at the first n terms, which are a basis of all.
func (a *Array) rank(mask []Offset) int {
	rows := make([][]int, len(a.state))
	for t := range rows {
		for _, o := range mask {
			rows[t] = append(rows[t], a.terms[(t+a.index(o.row, o.column))%a.size])
		}
	}
	return a.field.rank(rows)
}

// distance is the least number of cells in which two windows differ on the folding's own surface. The
// difference of two shifts of an m-sequence is a third one, or zeros if they are the same; so this is
// the least number of cells of a window that are not 0.
func (a *Array) distance(mask []Offset) int {
	least := len(mask)
	a.visit(a.ownSurface(), mask, func(_ Offset, content []int) {
		nonzero := 0
		for _, c := range content {
			if c != 0 {
				nonzero++
			}
		}
		if nonzero < least {
			least = nonzero
		}
	})
	return least
}

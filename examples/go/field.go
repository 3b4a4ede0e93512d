package main

import (
	"errors"
	"math/big"
)

var errImpossible = errors.New("impossible-profile")

// A Field is GF(q), q = p^m, of at most 256 elements. An element is its code: the number whose
// base-p digits are the coefficients of a polynomial over the integers modulo p, lowest degree
// first. Products are reduced by the modulus.
type Field struct {
	q, p, m   int
	modulus   []int
	exp, log  []int   // powers of the smallest primitive element, and which power an element is
	sum       [][]int // the table of sums
	negatives []int
}

// NewField makes the field of a modulus, the constant term first.
func NewField(q int, modulus []int) (*Field, error) {
	p, m, ok := primePower(q)
	if !ok || len(modulus) != m+1 || modulus[m] != 1 {
		return nil, errImpossible
	}
	for _, c := range modulus {
		if c >= p {
			return nil, errImpossible
		}
	}
	f := &Field{q: q, p: p, m: m, modulus: modulus}
	f.tabulateSums()
	for g := 1; g < q; g++ {
		if f.generatedBy(g) {
			return f, nil
		}
	}
	return nil, errImpossible
}

func primePower(q int) (p, m int, ok bool) {
	if q < 2 || q > 256 {
		return 0, 0, false
	}
	for p = 2; q%p != 0; p++ {
	}
	power := 1
	for ; power < q; m++ {
		power *= p
	}
	return p, m, power == q
}

func (f *Field) digits(a int) []int {
	digits := make([]int, f.m)
	for k := range digits {
		digits[k] = a % f.p
		a /= f.p
	}
	return digits
}

func (f *Field) code(digits []int) int {
	code := 0
	for k := f.m - 1; k >= 0; k-- {
		code = code*f.p + ((digits[k]%f.p)+f.p)%f.p
	}
	return code
}

func (f *Field) tabulateSums() {
	f.sum, f.negatives = make([][]int, f.q), make([]int, f.q)
	for a := range f.sum {
		f.sum[a] = make([]int, f.q)
		for b := range f.sum[a] {
			x, y := f.digits(a), f.digits(b)
			for k := range x {
				x[k] += y[k]
			}
			f.sum[a][b] = f.code(x)
			if f.sum[a][b] == 0 {
				f.negatives[a] = b
			}
		}
	}
}

// product is by the definition: multiply the polynomials, then take away multiples of the modulus.
func (f *Field) product(a, b int) int {
	z := make([]int, 2*f.m)
	for i, x := range f.digits(a) {
		for j, y := range f.digits(b) {
			z[i+j] += x * y
		}
	}
	for top := 2*f.m - 2; top >= f.m; top-- {
		factor := z[top] % f.p
		for k := 0; k < f.m; k++ {
			z[top-f.m+k] -= factor * f.modulus[k]
		}
	}
	return f.code(z)
}

// generatedBy tells whether the powers of g are all elements but 0. Then these have inverses, so
// that the modulus is irreducible; and if it is, there is such a g.
func (f *Field) generatedBy(g int) bool {
	f.exp, f.log = make([]int, f.q-1), make([]int, f.q)
	power := 1
	for i := range f.exp {
		if i > 0 && power <= 1 {
			return false
		}
		f.exp[i], f.log[power] = power, i
		power = f.product(power, g)
	}
	return power == 1
}

func (f *Field) add(a, b int) int { return f.sum[a][b] }

func (f *Field) multiply(a, b int) int {
	if a == 0 || b == 0 {
		return 0
	}
	return f.exp[(f.log[a]+f.log[b])%(f.q-1)]
}

// power is of an element that is not 0, to any integer.
func (f *Field) power(a int, exponent *big.Int) int {
	order := big.NewInt(int64(f.q - 1))
	rest := int(new(big.Int).Mod(exponent, order).Int64()) // Euclidean: not negative
	return f.exp[f.log[a]*rest%(f.q-1)]
}

func (f *Field) inverse(a int) int { return f.exp[(f.q-1-f.log[a])%(f.q-1)] }

// trace is a + a^p + ... + a^(p^(m-1)).
func (f *Field) trace(a int) int {
	total, power := 0, a
	for k := 0; k < f.m; k++ {
		total = f.add(total, power)
		if power != 0 {
			power = f.exp[f.log[power]*f.p%(f.q-1)]
		}
	}
	return total
}

// rank is that of a matrix, which is changed.
func (f *Field) rank(rows [][]int) int {
	rank := 0
	for column := 0; column < len(rows[0]) && rank < len(rows); column++ {
		pivot := rank
		for pivot < len(rows) && rows[pivot][column] == 0 {
			pivot++
		}
		if pivot == len(rows) {
			continue
		}
		rows[rank], rows[pivot] = rows[pivot], rows[rank]
		inverse := f.inverse(rows[rank][column])
		for _, row := range rows[rank+1:] {
			factor := f.negatives[f.multiply(row[column], inverse)]
			for k, x := range rows[rank] {
				row[k] = f.add(row[k], f.multiply(factor, x))
			}
		}
		rank++
	}
	return rank
}

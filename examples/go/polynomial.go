package main

import "math/big"

// Polynomials over the field are lists of codes, the constant term first.

// isPrimitive tells whether x has the order q^n - 1 modulo h, n its degree. Then h is irreducible as
// well.
func (f *Field) isPrimitive(h []int) bool {
	for len(h) > 0 && h[len(h)-1] == 0 {
		h = h[:len(h)-1]
	}
	n := len(h) - 1
	if n < 1 || h[n] != 1 || h[0] == 0 {
		return false
	}
	order := new(big.Int).Exp(big.NewInt(int64(f.q)), big.NewInt(int64(n)), nil)
	order.Sub(order, big.NewInt(1))
	if !f.isOne(order, h) {
		return false
	}
	for _, prime := range primeFactors(order) {
		if f.isOne(new(big.Int).Div(order, prime), h) {
			return false
		}
	}
	return true
}

// isOne tells whether x^exponent = 1 modulo h.
func (f *Field) isOne(exponent *big.Int, h []int) bool {
	n := len(h) - 1
	power := make([]int, n)
	power[0] = 1
	for bit := exponent.BitLen() - 1; bit >= 0; bit-- {
		square := make([]int, 2*n)
		shift := int(exponent.Bit(bit)) // times x, or not
		for i, a := range power {
			for j, b := range power {
				square[i+j+shift] = f.add(square[i+j+shift], f.multiply(a, b))
			}
		}
		for top := 2*n - 1; top >= n; top-- {
			factor := f.negatives[square[top]]
			for k := 0; k < n; k++ {
				low := top - n + k
				square[low] = f.add(square[low], f.multiply(factor, h[k]))
			}
		}
		power = square[:n]
	}
	for k, c := range power {
		if (k == 0) != (c == 1) || c > 1 {
			return false
		}
	}
	return true
}

// firstPrimitive is the first one of a degree, the coefficients compared from the highest degree
// down.
func (f *Field) firstPrimitive(degree int) []int {
	h := make([]int, degree+1)
	h[degree] = 1
	for !f.isPrimitive(h) {
		k := 0 // the next number whose base-q digits are the coefficients
		for h[k]++; h[k] == f.q; h[k]++ {
			h[k] = 0
			k++
		}
	}
	return h
}

// primeFactors are the primes that divide n: small ones by trial, others by Pollard's rho.
func primeFactors(n *big.Int) []*big.Int {
	var primes []*big.Int
	rest := new(big.Int).Set(n)
	take := func(prime *big.Int) {
		primes = append(primes, prime)
		for new(big.Int).Mod(rest, prime).Sign() == 0 {
			rest.Div(rest, prime)
		}
	}
	for d := int64(2); d < 1000; d++ {
		if new(big.Int).Mod(rest, big.NewInt(d)).Sign() == 0 {
			take(big.NewInt(d))
		}
	}
	one := big.NewInt(1)
	for rest.Cmp(one) > 0 {
		prime := new(big.Int).Set(rest)
		for !prime.ProbablyPrime(20) {
			prime = divisor(prime)
		}
		take(prime)
	}
	return primes
}

// divisor is a proper one of a composite number: where x -> x^2 + c runs into a cycle.
func divisor(n *big.Int) *big.Int {
	step := func(x, c *big.Int) *big.Int {
		x.Mul(x, x).Add(x, c)
		return x.Mod(x, n)
	}
	for c := big.NewInt(1); ; c.Add(c, big.NewInt(1)) {
		slow, fast, d := big.NewInt(2), big.NewInt(2), big.NewInt(1)
		for d.Cmp(big.NewInt(1)) == 0 {
			step(slow, c)
			step(step(fast, c), c)
			d.GCD(nil, nil, new(big.Int).Abs(new(big.Int).Sub(slow, fast)), n)
		}
		if d.Cmp(n) != 0 {
			return d
		}
	}
}

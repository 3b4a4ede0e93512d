-- | The array is the sequence folded.
module PraTactile.Conformance.Laws.Array
  ( arrayLaws,
  )
where

import PraTactile.Array (Folding (..), Position (..), Shape (..), area)
import PraTactile.Conformance.Implementation
import PraTactile.Conformance.Law
import PraTactile.Profile (Profile (..))

-- | The laws of the array and of packing its windows.
arrayLaws :: [Law Session]
arrayLaws =
  [ Law
      "a[i mod n1][i mod n2] = s(i) for the diagonal fold, a[i div n2][i mod n2] = s(i mod n1 n2) \
      \for the row-major one"
      ( \s ->
          let Shape n1 n2 = profileShape (profile s)
              at i = case profileFolding (profile s) of
                Diagonal -> Position (i `mod` n1) (i `mod` n2)
                RowMajor -> Position ((i `div` n2) `mod` n1) (i `mod` n2)
           in forTerms s (\i -> equal (cell s (at i)) (term s (i `mod` (n1 * n2))))
      ),
    Law
      "a window is packed as the base-q number of its cells and unpacked again"
      ( \s ->
          let k = fromIntegral (windowArea s)
           in forElements k s (\codes -> equal (pack s codes >>= unpack s) (pure codes))
      ),
    Law
      "the packed window 0 ... 0 1 is 1 or q^(cells - 1), as the profile says"
      ( \s ->
          let q = profileOrder (profile s)
              codes = replicate (fromIntegral (windowArea s) - 1) 0 ++ [1]
           in holds (`elem` [1, q ^ (windowArea s - 1)]) (pack s codes)
      ),
    Law
      "a number of q^cells or more unpacks to nothing: out-of-range"
      ( \s ->
          refuses "out-of-range" (unpack s (profileOrder (profile s) ^ windowArea s))
      )
  ]
  where
    windowArea = area . profileWindow . profile

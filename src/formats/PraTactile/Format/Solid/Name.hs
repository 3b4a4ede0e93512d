-- | The names of built-in solids, such as @box:100x60x40@.
module PraTactile.Format.Solid.Name
  ( SolidName (..),
    readName,
    nameForms,
  )
where

import Data.List (find)
import qualified Data.Text as Text
import PraTactile.Decimal (asciiOf, readExact)
import PraTactile.Format.Solid.Number (whole)
import PraTactile.Object.Named

-- | The meaning of a text as the name of a solid.
data SolidName
  = Known Named
  | -- | it begins like a name, but should have this form
    Malformed String
  | -- | it is the name of a regular solid without rational vertices
    Irrational String
  | -- | it is not a name
    NoName
  deriving stock (Eq, Show)

-- | The form of each name.
nameForms :: [String]
nameForms =
  [ "cube",
    "parallelepiped",
    "box:WxDxH",
    "pyramid:WxDxH",
    "prism:N,R,H",
    "tetrahedron:A",
    "octahedron:A",
    "pyritohedron:A",
    "l:WxDxH",
    "frame:WxDxH",
    "sheet"
  ]

-- | The solid with a name. Lengths are exact numbers of millimetres, such as @127/4@ or @31.75@.
-- The first argument is the width and the depth of the sheet.
readName :: (Rational, Rational) -> String -> SolidName
readName (wide, deep) text
  | name `elem` ["dodecahedron", "icosahedron"] = Irrational name
  | Just form <- find ((== name) . takeWhile (/= ':')) nameForms =
    maybe (Malformed form) Known (given >>= such)
  | otherwise = NoName
  where
    (name, rest) = break (== ':') text
    given = case (name, rest) of
      ("cube", "") -> Just Cube
      ("parallelepiped", "") -> Just Parallelepiped
      ("sheet", "") -> Just (Sheet wide deep)
      ("box", _) -> three Box
      ("pyramid", _) -> three Pyramid
      ("l", _) -> three LShape
      ("frame", _) -> three Frame
      ("tetrahedron", _) -> one Tetrahedron
      ("octahedron", _) -> one Octahedron
      ("pyritohedron", _) -> one Pyritohedron
      ("prism", _) -> case parts ',' of
        [n, r, h]
          | Right count <- whole (asciiOf (Text.unpack n)) ->
            Prism count <$> number r <*> number h
        _ -> Nothing
      _ -> Nothing
    such solid = if positive solid then Just solid else Nothing
    parts separator = case rest of
      ':' : values -> Text.split (== separator) (Text.pack values)
      _ -> []
    three make = case parts 'x' of
      [w, d, h] -> make <$> number w <*> number d <*> number h
      _ -> Nothing
    one make = case parts 'x' of
      [a] -> make <$> number a
      _ -> Nothing
    number = readExact . Text.unpack

-- | What messages advise does what it says: each is provoked, and followed to its end. The advice
-- of 'decode' about axes, scales and shades is followed by "Test.Recognition.TakenOtherwise", that
-- on tolerances of 'place' by "Test.CommandLine.Place".
module Test.CommandLine.Advice (spec) where

import Data.Foldable (for_)
import Data.List (isInfixOf)
import Test.CommandLine.Run
import Test.Hspec hiding (after, before)
import Test.Support

spec :: Spec
spec =
  for_ advised $ \(command, advice, followed) ->
    it (takeWhile (/= ' ') command ++ ": " ++ advice) . inFolder $ \folder -> do
      writeFile (folder ++ "/inches.obj") (block 5 False)
      writeFile (folder ++ "/turned.obj") (block 100 True)
      (before, said, err) <- scripted folder ("pra " ++ command)
      (before > 0, advice `isInfixOf` unwords (words (said ++ err))) `shouldBe` (True, True)
      -- What was said is there for an option to be taken out of it.
      writeFile (folder ++ "/said") (said ++ err)
      (after, _, _) <- scripted folder ("pra " ++ followed)
      after `shouldBe` 0

-- | A command, what it advises, and the command that follows it.
advised :: [(String, String, String)]
advised =
  [ ( "array --q 2 --polynomial 1,1,0,0,1 --shape 5x3",
      "give --window ROWSxCOLUMNS",
      "array --q 2 --polynomial 1,1,0,0,1 --shape 5x3 --window 2x2"
    ),
    ( "locate --road table '[[[0,0,0.1,0.9], 2], [3, 1]]' --doubt 0.2",
      "leave out --road",
      "locate '[[[0,0,0.1,0.9], 2], [3, 1]]' --doubt 0.2"
    ),
    ("locate '3 2'", "ambiguous", "locate '3 2 / 3 1'"),
    ( "place inches.obj",
      "is the file in inches? give --scale 25.4",
      "place inches.obj $(grep -o -- '--scale [0-9.]*' said)"
    ),
    ( "solid turned.obj",
      "with --fix-orientation it would be a solid",
      "solid turned.obj --fix-orientation"
    ),
    ( "solid pyritohedron:100/3 --output round.obj > log; pra solid round.obj",
      "it would be a solid",
      "solid round.obj $(grep -o -- '--tolerance [0-9.]*' said)"
    ),
    ( "objects --database none.db",
      "'pra-tactile objects --write FILE' makes one",
      "objects --write none.db && pra objects --database none.db"
    ),
    ( "objects --write made.db > log; pra objects --add cube --database made.db",
      "--replace puts another in its place",
      "objects --replace cube --database made.db"
    ),
    ( "emboss --object cube --face 'C1 C2 C3 C4' --thickness 0.1 --output top.stl",
      "a plate of 0.1 mm is not thicker than that: choose another --thickness",
      "emboss --object cube --face 'C1 C2 C3 C4' --thickness 4 --output top.stl"
    ),
    ( "emboss --net --page 100x100 --object cube --output pages",
      "choose a larger --page",
      "emboss --net --page 297x420 --object cube --output pages"
    ),
    ( "emboss --object cube --output part.txt",
      "ends in none of .stl, .obj, .3mf, .json, .svg",
      "emboss --object cube --output part.3mf"
    ),
    ( "probe --object cube --seed 1 --size 100x100 --at 100,100 --output frames",
      "does not lie on the face C6 C5 C8 C7, which is 127 x 127 mm; choose another --size or --at",
      "probe --object cube --seed 1 --size 60x60 --at 10,10 --output frames"
    ),
    ( "probe --object cube --seed 7 --output frames > log; "
        ++ "pra segment frames --no-stitching --position-error 1",
      "leave out --position-error",
      "segment frames --no-stitching"
    )
  ]

-- | A cube with sides of this length as OBJ; one of its faces may be walked the other way.
block :: Int -> Bool -> String
block side turned =
  unlines
    ( [ unwords ("v" : map show [x, y, z])
        | z <- [0, side],
          (x, y) <- [(0, 0), (side, 0), (side, side), (0, side)]
      ]
        ++ ["f 1 4 3 2", "f 5 6 7 8", "f 1 2 6 5", "f 2 3 7 6", "f 3 4 8 7"]
        ++ [if turned then "f 4 8 5 1" else "f 4 1 5 8"]
    )

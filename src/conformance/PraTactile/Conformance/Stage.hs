{-# OPTIONS_HADDOCK hide #-}

-- | The stages of a decoder, by which laws are named and chosen.
module PraTactile.Conformance.Stage
  ( Stage (..),
    stageName,
    codeStages,
    touchStages,
    objectStages,
    stagesApart,
  )
where

-- | In the order in which a decoder is written.
data Stage
  = -- | How a process starts, keeps a profile and stops, whatever it is asked.
    OnProtocol
  | OnProfile
  | OnField
  | OnPolynomial
  | OnSequence
  | OnArray
  | OnWindow
  | OnProof
  | OnLocate
  | OnDamage
  | OnChances
  | -- | From here on the stages of touch.
    OnRegister
  | OnStitch
  | OnSegment
  | -- | The answers of a network to images.
    OnNetwork
  | -- | Solids, faces laid on an array, and poses.
    OnObjects
  deriving stock (Eq, Ord, Show, Enum, Bounded)

-- | As @--stage@ takes it.
stageName :: Stage -> String
stageName stage = case stage of
  OnProtocol -> "protocol"
  OnProfile -> "profile"
  OnField -> "field"
  OnPolynomial -> "polynomial"
  OnSequence -> "sequence"
  OnArray -> "array"
  OnWindow -> "window"
  OnProof -> "proof"
  OnLocate -> "locate"
  OnDamage -> "damage"
  OnChances -> "chances"
  OnRegister -> "register"
  OnStitch -> "stitch"
  OnSegment -> "segment"
  OnNetwork -> "network"
  OnObjects -> "objects"

-- | The stages of the code, with the protocol that carries them.
codeStages :: [Stage]
codeStages = [OnProtocol .. OnChances]

-- | The stages of touch.
touchStages :: [Stage]
touchStages = [OnRegister .. OnNetwork]

-- | The stage of objects.
objectStages :: [Stage]
objectStages = [OnObjects]

-- | The sets of stages that know no profile, each with its name. They are tried where one of them
-- is named.
stagesApart :: [(String, [Stage])]
stagesApart = [("touch", touchStages), (stageName OnObjects, objectStages)]
